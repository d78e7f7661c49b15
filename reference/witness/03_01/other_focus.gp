\\ The sum of the distances to the foci: that of a point of the axis, and that with (-2c, 0) as the other focus
\\ of the mirror image.
read("reference/witness/shared/common.gp");
e = 0.6329189148806542; rho = 1.8594979280814699; R = 3.1547945556812667; X = 3.1250182263711865; Y = 0.4324231416148369;
read("reference/witness/shared/ellipse.gp");

both("printed 1", [e, rho, R, X, Y], r(0) + r(Pi), norm2([X, Y]) + norm2([X + 2*c, Y]));
