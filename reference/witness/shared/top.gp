\\ A top that turns about its moving tip.
th = 1/4; phi = 5/6; ps = -3/7; w = [1/3, -2/5, 9/2]; g = 981/100; alpha = 2/5; lambda = 3; t = 1/4;
letters = concat([th, phi, ps, g, alpha, lambda, t], w);
\\ Seven points, of masses 1 to 2; their places from the tip, on the axis at the mean distance l.
axis = [sin(th)*sin(phi), -cos(th)*sin(phi), cos(phi)];
one1 = [cos(th), sin(th), 0]; one2 = cross(axis, one1);
ring(k) = cos(ps + k*Pi/3)*one1 + sin(ps + k*Pi/3)*one2;
points = concat(vector(6, k, ring(k)/3 + 4/5*axis), [2*axis]); masses = [1, 1, 1, 1, 1, 1, 2];
m = vecsum(masses); l = sum(k = 1, 7, masses[k]*dot(points[k], axis))/m;
\\ w' by the principle of virtual work: no turn e about the tip takes work from the forces and the accelerations.
turned(e, a) = sum(k = 1, 7, masses[k]*dot(cross(e, points[k]), a(points[k])));
unit(i) = vector(3, j, i == j);
angular(tip) = {
  my(inertia = matrix(3, 3, i, j, turned(unit(i), q -> cross(unit(j), q))));
  my(rest = vectorv(3, i, turned(unit(i), q -> tip + cross(w, cross(w, q)) + [0, 0, g])));
  -matsolve(inertia, rest)~;
}
tip = [-alpha*lambda^2*sin(lambda*t), 0, 0];
A(a) = q -> tip + cross(a, q) + cross(w, cross(w, q));
moment(a, o) = sum(k = 1, 7, masses[k]*cross(points[k] - o, A(a)(points[k]) - A(a)(o)));
a = angular(tip);
