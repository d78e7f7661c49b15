\\ The orbit r = e rho/(1 + e cos(theta)), and the letters of its ellipse; e and rho are set before.
r(theta) = e*rho/(1 + e*cos(theta));
c = e^2*rho/(1 - e^2); a = e*rho/(1 - e^2); b = a*sqrt(1 - e^2);
