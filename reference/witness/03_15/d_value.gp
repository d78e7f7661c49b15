\\ The mass on the turning rod comes to (0, d, d): d = lambda(2)/sqrt(2).
read("reference/witness/shared/common.gp");
read("reference/witness/shared/rod.gp");

both("printed 1", [], follow(rod(), [L/2, 0], 2, 12)[1]/sqrt(2), 0.814683);
