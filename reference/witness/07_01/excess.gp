\\ What full elimination costs more than forward elimination and back substitution, by the counts.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/elimination.gp");
n = 200;
both("printed 1", n, (at(n, full) + [0, 0, n] - at(n, forward)), n*(n - 1)/6*[2*n - 1, n, 0]);
