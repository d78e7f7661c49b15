\\ The lengths of the axes: r(0) + r(pi), and twice the highest point, where the slope of r sin(theta) is zero.
read("reference/witness/shared/common.gp");
e = 3.251408281888132e-05; rho = 32207.04802190042; R = 1.0471948245322933; X = -0.3751542555634196; Y = 0.9776892579239465;
read("reference/witness/shared/ellipse.gp");

top = solve(theta = 1, 2, cos(theta)*(1 + e*cos(theta)) + e*sin(theta)^2);
both("printed 1", [e, rho, R, X, Y], [r(0) + r(Pi), 2*r(top)*sin(top)], [a, b]);
