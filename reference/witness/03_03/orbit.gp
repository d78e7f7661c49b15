\\ The distance later on the path, and e rho/(1 + e cos(theta)) there.
read("reference/witness/shared/common.gp");
G = 0.7181325573503049; M = 0.6074529761854081; r0 = 1.5955816519087922; rd = 0.2198294189545271;
th = 0.8159289045717899; thd = 0.18551849395591855; t = 11.009327934796246;
letters = [G, M, r0, rd, th, thd, t];
read("reference/witness/shared/kepler.gp");
z = follow(fall, start, t, 80); q = norm2(z[1..2]);
e = sqrt((r0^3*thd^2 - mu)^2 + (r0^2*rd*thd)^2)/mu;
both("printed 1", letters, q, (h^2/mu)/(1 + e*z[1]/q));
