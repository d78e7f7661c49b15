\\ When the mass slides off the upper end, lambda = 4, from 3 with the spring K = 1.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/rod.gp");

from = rod(Pi/4, spring(0, 3, 0), 1);
one("corrected 2", [], solve(t = 1.5, 1.9, follow(from, [3, 0], t, 8)[1] - L), none);
