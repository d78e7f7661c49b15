\\ A bead on (q, q^2, q^3): its acceleration, of which q'' follows from x'' + (0, 0, g) being at right angles to the
\\ wire.
read("reference/witness/shared/common.gp");
m = 1.4396934458294082; g = 3.4035870517643416; q = 0.272086536973659; u = 0.9047934363644065; given = 0.060645450567151184;
along = [1, 2*q, 3*q^2]; bend = [0, 2, 6*q];
a = -dot(along, bend*u^2 + [0, 0, g])/dot(along, along);
both("printed 1", [m, g, q, u, given], along*a + bend*u^2, [0, 0, -g]);
