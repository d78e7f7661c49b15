\\ A particle at rest on the top stays there, (v1 t, v2 t) with v = 0: v1^2/a1^2 + v2^2/a2^2, which has to be g/2 by
\\ what is printed.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/hill.gp");

v = [0, 0];
if(acceleration([0, 0], v) != [0, 0, 0], error("it does not stay"));
case(concat([g, a1, a2], v), v[1]^2/a1^2 + v[2]^2/a2^2, g/2);
