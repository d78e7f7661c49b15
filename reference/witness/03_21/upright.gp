\\ The determinant of the kinetic energy of pipe and disk in theta' and psi', T = (m L^2 + mu2) sin^2(phi) theta'^2/2 + mu3
\\ (psi' + theta' cos(phi))^2/2, of an upright pipe: the equations do not say theta'' then.
read("reference/witness/shared/common.gp");
J = 7/5; mu3 = 3/5; phi = 0;
T(u, v) = J*sin(phi)^2*u^2/2 + mu3*(v + u*cos(phi))^2/2;
twice = [2*T(1, 0), T(1, 1) - T(1, 0) - T(0, 1); T(1, 1) - T(1, 0) - T(0, 1), 2*T(0, 1)];
case([J, mu3, phi], matdet(twice), nonzero);
