\\ The helix (cos t, sin t, t)/sqrt(1 + t^2) on the unit sphere: its velocity along Q, which points to the pole.
read("reference/witness/shared/common.gp");
t = 0;
read("reference/witness/shared/spherical_helix.gp");
both("printed 1", t, dot(rate(r, t), Q), -1/(1 + t^2));
