\\ lambda(2) of the mass on the turning rod from rest at L/2, by the equation of motion.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/rod.gp");

both("printed 1", [], follow(rod(), [L/2, 0], 2, 12)[1], 1.15214);
