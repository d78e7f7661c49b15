\\ The angular velocity of the frame r, u, r x u, read off the skew matrix M' M^T, and the listing's three entries.
read("reference/witness/shared/common.gp");
t = 0.8720078413170365;
read("reference/witness/shared/sphere_curve.gp");
s = t + x + O(x^6);
p = r(s); v = deriv(p, x); u = v/sqrt(dot(v, v));
M = Mat([p~, u~, cross(p, u)~]);
S = apply(c -> polcoef(c, 0), deriv(M, x)*M~);
if(norml2(S + S~) > 1e-80, error("not skew"));
R = r(t); V = rate(r, t); A = rate(r, t, 2); U = V/norm2(V);
D = (A - dot(R, U)*U)/norm2(V);
N = cross(R, U); E1 = cross(R, D);
W = [-(V[2]*R[3] + D[2]*U[3] + E1[2]*N[3]), V[1]*R[3] + D[1]*U[3] + E1[1]*N[3], -(V[1]*R[2] + D[1]*U[2] + E1[1]*N[2])];
both("printed 1", t, [S[3,2], S[1,3], S[2,1]], W);
