\\ The two pulleys of 3.19, by Lagrange and by Newton, at letters that are set before.
\\ Lagrange: the kinetic energy's matrix, and minus the slopes of the potential energy
V(y2, y3) = -m2*g*y2 - m3*g*y3 + c1/2*(K1 + y2 - L1)^2 + c2/2*(K2 + y3 - 2*y2 - L2)^2;
F = -[polcoef(V(y2 + x, y3), 1), polcoef(V(y2, y3 + x), 1)]~;
a = matsolve([m2 + I1/R1^2 + I2/R2^2, -I2/R2^2; -I2/R2^2, m3 + I2/R2^2], F);
pull1 = c1*(K1 - L1 + y2); pull2 = c2*(K2 - L2 + y3 - 2*y2);
\\ Newton: the tensions of the three ropes
M = [m2, 0, 1, -1; 0, m3, 0, 1; I1/R1^2, 0, -1, 0; -I2/R2^2, I2/R2^2, 0, -1];
N = matsolve(M, [m2*g + pull2, m3*g, -pull1, -pull2]~);
if(apart(N[1..2], a) > 1e-40, error("Newton is not Lagrange"));
