\\ The kinetic energy of a cone that hangs by its vertex and swings: its axis turns with W = R x R', which is across.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/cone.gp");

th = 6/5; phi = 2/3; u = 3/4; v = -5/4; lambda = 2/5; spin = 1/3;
axis(th, phi) = [cos(th)*sin(phi), sin(th)*sin(phi), -cos(phi)];
rates = apply(f -> polcoef(f, 1), axis(th + u*x + O(x^3), phi + v*x + O(x^3)));

R = axis(th, phi); W = cross(R, rates);
w = spin*[cos(lambda), 0, -sin(lambda)]; along = intnum(z = 0, h, Pi*(r*(1 - z/h))^4/2);
of(J, w) = J*(dot(w, w) - dot(R, w)^2)/2 + along*dot(R, w)^2/2;
L = 3*h/4; moving = m/2*L^2*dot(rates, rates);
printed = moving + of(across(0), w); corrected = moving + of(3*m*(h^2 + 4*r^2)/80, W);
formula([h, r, th, phi, u, v, lambda, spin], across(h)*dot(W, W)/2, printed, corrected);
