\\ How far the ball is from the origin after 5 s with a = 10, less that with a = 5: the printed sentence has it negative.
read("reference/witness/shared/common.gp");
far(a) = abs((exponential([0, 1; -4, -a]*5)*[1, 0]~)[1]);
case([1, 4, 5, 10], sign(far(10) - far(5)), -1);
