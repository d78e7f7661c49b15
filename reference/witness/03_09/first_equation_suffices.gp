\\ The first time at the origin of a ball from p = (0, -3/5) with v = p/5. The first equation is 0 = 0 there, and
\\ its quotient 0/0; the corrected one is of products by p.
read("reference/witness/shared/common.gp");
m = 1; c = 4; a = 1;
read("reference/witness/shared/ball.gp");

p = [0, -3/5]; v = p/5; alpha = -a/2; beta = sqrt(4*m*c - a^2)/2;
right = solve(t = 0.5, 1.5, at(t, p[2], v[2]));
printed = iferr(atan(-beta*p[1]/(v[1] - alpha*p[1]))/beta, E, none);
corrected = atan(-beta*dot(p, p)/dot(v - alpha*p, p))/beta;
formula(concat([m, c, a], concat(p, v)), right, printed, if(corrected < 0, corrected + Pi/beta, corrected));
