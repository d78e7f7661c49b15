\\ The derivative of the kinetic energy by theta', m the planet's mass and M the sun's.
read("reference/witness/shared/common.gp");
m = 3/7; M = 5; q = 6/5; w = 2/3;
T(w) = m*q^2*w^2/2;
formula([m, M, q, w], polcoef(T(w + x), 1), M*q^2*w, m*q^2*w);
