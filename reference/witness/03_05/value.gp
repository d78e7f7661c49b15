\\ The pendulum's integral of 1/sqrt(cos psi - cos(pi/6)) from 0 to pi/6; sin(psi/2) = sin(pi/12) sin u takes the
\\ singular end away.
read("reference/witness/shared/common.gp");
k = sin(Pi/12);
right = intnum(u = 0, Pi/2, sqrt(2)/sqrt(1 - k^2*sin(u)^2));
both("printed 1", [], right, 0.800275);
