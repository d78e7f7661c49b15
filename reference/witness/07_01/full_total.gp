\\ What full elimination and the division cost, by the count: of mu, alpha and delta.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/elimination.gp");
n = 200;
both("printed 1", n, at(n, full) + [0, 0, n], [2, 1, 0]*(n - 1)*n*(n + 1)/2 + [0, 0, n]);
