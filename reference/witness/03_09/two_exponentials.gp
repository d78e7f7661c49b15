\\ The ball at t = 1 at critical damping, m = 1, c = 4, a = 4, from 1 at rest, by the exponential of its matrix.
\\ The two exponentials' constants divide by r1 - r2 = 0.
read("reference/witness/shared/common.gp");
m = 1; c = 4; a = 4;
read("reference/witness/shared/ball.gp");

r = [(-a + sqrt(a^2 - 4*m*c))/2, (-a - sqrt(a^2 - 4*m*c))/2];
K1(p, v) = if(r[1] == r[2], none, (v - r[2]*p)/(r[1] - r[2]));
both("printed 1", [m, c, a, 0], at(1, 1, 0), K1(1, 0));
