\\ The work of the force (t, t, 1) over a circle: the first three times from omega T = -3 on at which its rate,
\\ the power, is zero, as omega T, found on a grid.
read("reference/witness/shared/common.gp");
r = 1.0065271687776924; w = 0.21882004879097347; T = 52.94662650101536;
power(t) = dot([t, t, 1], [-r*w*sin(w*t), r*w*cos(w*t), 0]);
found = [];
h = 2/15;
for(i = 0, 60, my(a = (-3 + i*h)/w, b = (-3 + (i + 1)*h)/w); \
  if(power(a)*power(b) < 0, found = concat(found, w*solve(t = a, b, power(t)))));
both("printed 1", [r, w, T], found[1..3], [Pi/4 - Pi, Pi/4, Pi/4 + Pi]);
