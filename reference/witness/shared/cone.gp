\\ A solid cone, in slices.
h = 8/5; r = 6/5;
\\ slices of the cone at the height z above its base
volume(from = 0) = intnum(z = from, h, Pi*(r*(1 - z/h))^2);
center = intnum(z = 0, h, z*Pi*(r*(1 - z/h))^2)/volume();
\\ about an axis across at the height o: each disk has pi rho^4/4 + pi rho^2 (z - o)^2
across(o) = intnum(z = 0, h, my(q = r*(1 - z/h)); Pi*q^4/4 + Pi*q^2*(z - o)^2);
m = volume();
