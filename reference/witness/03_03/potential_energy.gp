\\ The force on a planet of mass m at the distance q, by Newton's law, and -dV/dr for V = -GM/r.
read("reference/witness/shared/common.gp");
G = 2/3; M = 5; m = 3/7; q = 6/5;
slope(f) = polcoef(f(q + x + O(x^3)), 1);
formula([G, M, m, q], -G*M*m/q^2, -slope(r -> -G*M/r), -m*slope(r -> -G*M/r));
