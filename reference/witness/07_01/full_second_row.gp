\\ What full elimination costs with the second row, by the count: of mu, alpha and delta.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/elimination.gp");
n = 200;
both("printed 1", n, at(n, clearing(2)), [2*(n - 1)^2, (n - 1)^2, 0]);
