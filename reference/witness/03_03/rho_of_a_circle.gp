\\ A circle, GM = 4, r_0 = 4, theta'_0 = 1/4: the distance at t, and by e rho = (gamma_1/GM)(gamma_0^2/gamma_1).
read("reference/witness/shared/common.gp");
G = 2; M = 2; r0 = 4; rd = 0; th = 0; thd = 1/4; t = 6.283185307179586;
read("reference/witness/shared/kepler.gp");

g0 = r0^2*thd; g1 = abs(r0^3*thd^2 - mu);
both("printed 1", [G, M, r0, rd, th, thd, t], norm2(follow(fall, start, t, 8)[1..2]), iferr((g1/mu)*(g0^2/g1), E, none));
