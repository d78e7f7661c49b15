\\ F.(c i - x) at the end of the motion, F by Hooke's law, as a sign: the printed sentence has it positive.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/rod.gp");

s = follow(rod(), [L/2, 0], 2, 12)[1]; x = [0, s, s]/sqrt(2); to = [c, 0, 0] - x;
F = K*(norm2(to) - spring(0, L/2, 0))*to/norm2(to);
case([L, c, m, K], sign(dot(F, to)), 1);
