\\ A solid cone that swings by its vertex, at letters that the suite shows; the cone in slices.
h = 1.943912114171028; r = 1.9330413783701181; lambda = -1.4399326269005264; spin = 1.7805837637740243;
L = 1.457934085628271; g = 9.188802692963227;
th = 2.982114656507422; phi = 1.3411463705054436; u = 0.13671683869841866; v = -0.5802586999487462;
letters = [h, r, lambda, L, spin, g, th, phi, u, v];
\\ slices of the cone at the height z above its base
volume(from = 0) = intnum(z = from, h, Pi*(r*(1 - z/h))^2);
center = intnum(z = 0, h, z*Pi*(r*(1 - z/h))^2)/volume();
\\ about an axis across at the height o: each disk has pi rho^4/4 + pi rho^2 (z - o)^2
across(o) = intnum(z = 0, h, my(q = r*(1 - z/h)); Pi*q^4/4 + Pi*q^2*(z - o)^2);
m = volume();
