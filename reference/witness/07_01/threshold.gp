\\ The sign of what full elimination costs more with mu = 1, alpha = 5 at n = 9/8, above mu/(2 mu + alpha), the counts
\\ continued as polynomials.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/elimination.gp");
n = 9/8;
case([1, 5, n], sign((at(n, full) + [0, 0, n] - at(n, forward))*[1, 5, 0]~), 1);
