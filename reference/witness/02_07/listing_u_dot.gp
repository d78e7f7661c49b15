\\ The derivative of the unit tangent u = r'/|r'| of a curve on the unit sphere, and the listing's.
read("reference/witness/shared/common.gp");
t = 0.990041702625021;
read("reference/witness/shared/sphere_curve.gp");
v(t) = my(d = deriv(r(t), x)); d/sqrt(dot(d, d));
s = t + x + O(x^6);
right = apply(c -> polcoef(c, 1), v(s));
R = r(t); V = rate(r, t); A = rate(r, t, 2); U = V/norm2(V);
both("printed 1", t, right, (A - dot(R, U)*U)/norm2(V));
