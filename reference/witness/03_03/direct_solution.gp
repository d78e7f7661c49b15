\\ An orbit like the Earth's, from its aphelion by Runge-Kutta 4 on Newton's law, 52 steps a turn: how far it is off after ten
\\ turns, over half its axis; it should be a tenth at least.
read("reference/witness/shared/common.gp");
e = 1/10; h = 2*Pi/52;
pull(z) = my(d = norm2(z[1..2])^3); [z[3], z[4], -z[1]/d, -z[2]/d];
start = 1.*[1 + e, 0, 0, sqrt((1 - e)/(1 + e))];
z = start;
for(i = 1, 520, a = pull(z); b = pull(z + h/2*a); c = pull(z + h/2*b); d = pull(z + h*c); z += h/6*(a + 2*b + 2*c + d));
off = norm2(z[1..2] - start[1..2]);
if(off >= 1/10, error("it is off"));
case([e, 52], off, 1/10);
