\\ An overdamped ball thrown at the origin, from 1 with the velocity -9: the time at which it is there.
read("reference/witness/shared/common.gp");
m = 1; c = 4; a = 5;
read("reference/witness/shared/ball.gp");

case([m, c, a, 1, -9], solve(t = 0.1, 0.3, at(t, 1, -9)), none);
