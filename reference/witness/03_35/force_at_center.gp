\\ The rate of the top's angular momentum about its center of mass. A force on the center of mass leaves it zero;
\\ corrected it is the torque of a force N on the tip.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/top.gp");

N = m*(A(a)(l*axis) + [0, 0, g]);
formula(letters, moment(a, l*axis), [0, 0, 0], cross(-l*axis, N));
