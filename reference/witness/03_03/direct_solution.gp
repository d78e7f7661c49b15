\\ The Earth's orbit, ten turns from its aphelion by Runge-Kutta 4 on (3.1), 365 steps a turn: 1 where the planet is lost,
\\ a tenth of the orbit from where it has to be.
read("reference/witness/shared/common.gp");
e = 167/10000; turn = 2*Pi/(1 + e)^(3/2);
fall(z) = my(q = norm2(z[1..2])); [z[3], z[4], -z[1]/q^3, -z[2]/q^3];
start = [1, 0, 0, sqrt(1 - e)]*1.;
z = start; h = turn/365;
for(i = 1, 3650, k1 = fall(z); k2 = fall(z + h/2*k1); k3 = fall(z + h/2*k2); k4 = fall(z + h*k3); \
  z += h/6*(k1 + 2*k2 + 2*k3 + k4));
off = norm2((z - start)[1..2])*(1 + e);
if(off > 1/1000000, error("farther off than a millionth"));
case(e, off >= 1/10, 1);
