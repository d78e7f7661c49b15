\\ The lengths of the axes: r(0) + r(pi), and twice the highest point, where the slope of r sin(theta) is zero.
read("reference/witness/shared/common.gp");
e = 1.20227717306444e-06; rho = 1220285.7036758615; X = -1.2737140467026542; Y = -0.7280816885493481;
read("reference/witness/shared/ellipse.gp");

top = solve(theta = 1, 2, cos(theta)*(1 + e*cos(theta)) + e*sin(theta)^2);
both("printed 1", [e, rho, X, Y], [r(0) + r(Pi), 2*r(top)*sin(top)], [a, b]);
