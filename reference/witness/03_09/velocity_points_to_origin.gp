\\ p.v of a ball that comes to the origin though it sets off away from it, p = (1, 2), v = p; the printed sentence has it
\\ negative.
read("reference/witness/shared/common.gp");
m = 1; c = 4; a = 1;
read("reference/witness/shared/ball.gp");

p = [1, 2]; v = p;
t = solve(t = 0.5, 2, at(t, p[1], v[1]));
if(abs(at(t, p[2], v[2])) > 1e-40, error("it does not arrive"));
case(concat([m, c, a], concat(p, v)), sign(dot(p, v)), -1);
