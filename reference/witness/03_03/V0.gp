\\ V(theta) = c0 sin(theta) + c1 cos(theta) - (GM/h)^2 at the start, its constants from V = -GM/r at two later places of
\\ the path in the plane.
read("reference/witness/shared/common.gp");
G = 0.43979638855954184; M = 0.69377838462622; r0 = 0.49001815328762877; rd = -0.03942109412373655;
th = -1.460806877917899; thd = -2.061134276048091; t = 3.0582503374574026;
letters = [G, M, r0, rd, th, thd, t];
read("reference/witness/shared/kepler.gp");
read("reference/witness/shared/kepler_constants.gp");

both("printed 1", letters, c[1]*sin(th) + c[2]*cos(th) - (mu/h)^2, mu/r0);
