\\ The kinetic energy of a cone that hangs by its vertex and swings: its axis turns with W = R x R', which is across.
\\ The third axis points down, the second one north.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/cone.gp");

axis(th, phi) = [cos(th)*sin(phi), sin(th)*sin(phi), cos(phi)];
rates = apply(f -> polcoef(f, 1), axis(th + u*x + O(x^3), phi + v*x + O(x^3)));

R = axis(th, phi); W = cross(R, rates);
w = spin*[0, cos(lambda), -sin(lambda)]; along = intnum(z = 0, h, Pi*(r*(1 - z/h))^4/2);
of(J, w) = J*(dot(w, w) - dot(R, w)^2)/2 + along*dot(R, w)^2/2;
moving(L) = m/2*L^2*dot(rates, rates);
printed = moving(h/2^(1/3)) + of(across(0), w); corrected = moving(3*h/4) + of(3*m*(h^2 + 4*r^2)/80, W);
both("printed 1", letters, across(h)*dot(W, W)/2, printed, corrected);
