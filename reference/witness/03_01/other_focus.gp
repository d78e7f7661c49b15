\\ The sum of the distances to the foci: that of a point of the axis, and that with (2c, 0) as the other focus.
read("reference/witness/shared/common.gp");
e = 0.6648583741224057; rho = 7.573119176166052; X = -14.958954701385755; Y = 0.8057228083126117;
read("reference/witness/shared/ellipse.gp");

both("printed 1", [e, rho, X, Y], r(0) + r(Pi), norm2([X, Y]) + norm2([X - 2*c, Y]));
