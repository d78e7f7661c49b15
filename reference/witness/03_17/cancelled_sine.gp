\\ At phi = 0: m L^2 sin(phi) times the equation that is left by the cancellation, which holds at any velocity, and that
\\ equation itself, in parts of phi'.
read("reference/witness/shared/common.gp");
th = 1/2; u = -3/5; v = 2/3; lambda = 7/5; spin = 8/5; phi = 0;
left = 2*u*v*cos(phi) - 2*spin*v*(-cos(lambda)*sin(th)*sin(phi) + sin(lambda)*cos(phi));
case([th, u, v, lambda, spin], sin(phi)*left, left/v);
