\\ R' R^T of a turn about a moving axis, t + t^2 about (cos t, sin t, t)/sqrt(1 + t^2): its determinant.
\\ An invertible matrix has another one.
read("reference/witness/shared/common.gp");
t = 7/10; s = t + x + O(x^4);
D = [cos(s), sin(s), s]/sqrt(1 + s^2); S = [0, -D[3], D[2]; D[3], 0, -D[1]; -D[2], D[1], 0];
angle = s + s^2;
R = matid(3) + sin(angle)*S + (1 - cos(angle))*S^2;
M = apply(c -> polcoef(c, 0), deriv(R, x)*R~);
if(norml2(M) < 1, error("at rest"));
case(t, matdet(M), nonzero);
