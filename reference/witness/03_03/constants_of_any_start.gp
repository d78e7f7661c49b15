\\ A planet at rest: V(theta_0) by (3) with (4) and (5), which divide by theta'_0, less -GM/r_0. It has to be zero.
read("reference/witness/shared/common.gp");
G = 4.554425405935752; M = 0.8357673391341788; r0 = 2.2618819843172573; rd = 0; th = -1.3476886827145989; thd = 0;
mu = G*M;
c0() = (-mu/r0 + mu^2/(r0^4*thd^2))*sin(th) + mu*rd/(r0^2*thd)*cos(th);
both("printed 1", [G, M, r0, rd, th, thd], 0, iferr(c0(), E, none));
