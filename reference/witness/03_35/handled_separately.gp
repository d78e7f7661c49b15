\\ The angular acceleration of the top: the tip moving, and fixed. Corrected: by its inertia about the tip, with the
\\ torque of -m p'' beside gravity's.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/top.gp");

J = sum(k = 1, 7, masses[k]*(dot(points[k], points[k])*matid(3) - points[k]~*points[k]));
euler = matsolve(J, (cross(l*axis, -m*(tip + [0, 0, g])) - cross(w, (J*w~)~))~)~;
formula(letters, a, angular([0, 0, 0]), euler);
