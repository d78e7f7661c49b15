\\ A planet's path in the plane from its start in polar coordinates, which is set before.
mu = G*M; h = r0^2*thd;
start = [r0*cos(th), r0*sin(th), rd*cos(th) - r0*thd*sin(th), rd*sin(th) + r0*thd*cos(th)];
fall(t, z) = my(q = sqrt(z[1]^2 + z[2]^2)^3); [z[3], z[4], -mu*z[1]/q, -mu*z[2]/q];
