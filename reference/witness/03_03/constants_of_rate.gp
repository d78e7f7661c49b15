\\ theta' later on the path, and by equation (7) with the constants as printed.
read("reference/witness/shared/common.gp");
G = 3.053550468881087; M = 2.623775973119718; r0 = 2.841949179940209; rd = -0.4786211510932368;
th = 1.2687682814630543; thd = -0.4943912622337107; t = 9.078025216508571;
letters = [G, M, r0, rd, th, thd, t];
read("reference/witness/shared/kepler.gp");
z = follow(fall, start, t, 80); q = norm2(z[1..2]);
bracket = mu/r0 + mu^2/(r0^4*thd^2); slope = mu*rd/(r0^2*thd);
c0 = bracket*sin(th) + slope*cos(th); c1 = bracket*cos(th) - slope*sin(th);
both("printed 1", letters, (z[1]*z[4] - z[2]*z[3])/q^2, h/mu^2*(c0*z[2]/q + c1*z[1]/q - (mu/h)^2)^2);
