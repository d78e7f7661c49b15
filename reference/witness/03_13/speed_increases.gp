\\ A ball sent up the chute along its center line: the change of |x1'| in a millisecond, as a sign.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/chute.gp");

u = -3/2; th = Pi/6;
a = acceleration(th, 2, 0, [u, 0, -u*tan(th)], 0);
case([g, th, 2, u], sign(abs(u + a[1]/1000) - abs(u)), 1);
