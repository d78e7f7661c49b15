\\ x2'' of a ball that crosses the center line, with viscous friction k. The form S x2 makes it zero; corrected it is
\\ what it is without friction, less k x2'.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/chute.gp");

th = Pi/5; R = 7/4; u = [3/4, -6/5, -3/4*tan(th)];
formula(concat([g, k, th, R], u), acceleration(th, R, 0, u, k)[2], 0, acceleration(th, R, 0, u, 0)[2] - k*u[2]);
