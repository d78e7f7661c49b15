\\ What the shaking adds to the rate of the top's angular momentum about its center of mass: that of the driven tip
\\ less that of a fixed one, at the same angles and rates. A force on the center of mass adds nothing; corrected it is
\\ the torque of what it adds to the force N on the tip.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/top.gp");

fixed = angular([0, 0, 0]);
N = m*(A(a)(l*axis) + [0, 0, g]);
N0 = m*(A(fixed)(l*axis) - tip + [0, 0, g]);
formula(letters, moment(a, l*axis) - moment(fixed, l*axis), [0, 0, 0], cross(-l*axis, N - N0));
