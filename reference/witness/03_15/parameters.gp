\\ lambda(2) from b = 1/sqrt(2) and from b = sqrt(2), with the same L, c, m and K, which alone are printed as parameters.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/rod.gp");

from(s) = follow(rod(Pi/4, spring(0, s, 0)), [s, 0], 2, 12)[1];
both("printed 1", [], from(1), from(2));
