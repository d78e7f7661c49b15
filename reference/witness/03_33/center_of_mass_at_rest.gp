\\ The velocity of the top's center of mass in body coordinates, R^T r' for R = Rz(theta) Rx(phi) Rz(psi).
read("reference/witness/shared/common.gp");
l = 5/4; th = 4/5; phi = 7/6; ps = -1/3; u = 2/3; v = -3/4; s = 9/5;
Rz(a) = [cos(a), -sin(a), 0; sin(a), cos(a), 0; 0, 0, 1];
Rx(a) = [1, 0, 0; 0, cos(a), -sin(a); 0, sin(a), cos(a)];
R(t) = Rz(th + u*t)*Rx(phi + v*t)*Rz(ps + s*t);
velocity = apply(c -> polcoef(c, 1), R(x + O(x^3))*[0, 0, l]~);
w1 = u*sin(phi)*sin(ps) + v*cos(ps); w2 = u*sin(phi)*cos(ps) - v*sin(ps);
formula([l, th, phi, ps, u, v, s], R(0)~*velocity, [0, 0, 0], l*[w2, -w1, 0]);
