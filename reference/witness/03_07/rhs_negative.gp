\\ The sign of q'' of the bead beyond the origin, at q = -1/10: x'' + (0, 0, g) is at right angles to the wire.
read("reference/witness/shared/common.gp");
g = 1; q = -1/10; u = -7/5;
along = [1, 2*q, 3*q^2]; bend = [0, 2, 6*q];
a = -dot(along, bend*u^2 + [0, 0, g])/dot(along, along);
case([g, q, u], sign(a), -1);
