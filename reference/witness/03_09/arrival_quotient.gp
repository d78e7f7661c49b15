\\ The first time at the origin of a ball with v = alpha p, for which the quotient divides by zero.
read("reference/witness/shared/common.gp");
m = 1; c = 4; a = 1;
read("reference/witness/shared/ball.gp");

p = 3/2; alpha = -a/2; v = alpha*p; beta = sqrt(4*m*c - a^2)/2;
printed = iferr(atan(-beta*p/(v - alpha*p))/beta, E, none);
formula([m, c, a, p, v], solve(t = 0.5, 1.5, at(t, p, v)), printed, arg(-(v - alpha*p) + I*beta*p)/beta);
