\\ The acceleration of the same helix along Q.
read("reference/witness/shared/common.gp");
t = -2.323206155720282;
read("reference/witness/shared/spherical_helix.gp");
both("printed 1", t, dot(rate(r, t, 2), Q), -t/(1 + t^2));
