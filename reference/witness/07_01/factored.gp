\\ The difference of the printed costs C' and C, of mu, alpha and delta, and as factored in print.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/elimination.gp");
n = 200;
full = [2, 1, 0]*(n - 1)*n*(n + 1)/2 + [0, 0, n];
forward = [2, 1, 0]*(n - 1)*n*(n + 1)/3 + [1, 1, 0]*n*(n - 1)/2 + [0, 0, n];
both("printed 1", n, (full - forward), n*(n - 1)/6*[2*n - 1, n, 0]);
