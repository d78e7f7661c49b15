\\ A particle above the long axis of the hill, faster or slower than the condition has it: its acceleration across
\\ the axis. On a path that is not straight it is not zero.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/hill.gp");

case([g, a1, a2], vector(4, k, acceleration([k/3, 0], [k/5, 0])[2]), nonzero);
