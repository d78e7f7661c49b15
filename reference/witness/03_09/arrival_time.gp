\\ The first time at the origin of a ball let go at rest, and the principal value.
read("reference/witness/shared/common.gp");
m = 1; c = 4; a = 1;
read("reference/witness/shared/ball.gp");

p = 3/2; v = 0; alpha = -a/2; beta = sqrt(4*m*c - a^2)/2;
printed = atan(-beta*p/(v - alpha*p))/beta;
formula([m, c, a, p, v], solve(t = 0.5, 1.5, at(t, p, v)), printed, printed + Pi/beta);
