\\ Twice the area between u = (1, 0, 0), v = (2, 0, 0) and w = -u - v: a triangle has another one than 0.
read("reference/witness/shared/common.gp");
u = [1, 0, 0]; v = [2, 0, 0]; w = -u - v;
case(concat(u, v), norml2(cross(u, v)), nonzero);
