\\ A point of the ellipse with the minus sign: its distance from the origin, which is printed as a solution, and that
\\ of the orbit in its direction.
read("reference/witness/shared/common.gp");
e = 0.6648583741224057; rho = 7.573119176166052; R = 14.980638003835022; X = -14.958954701385755; Y = 0.8057228083126117;
read("reference/witness/shared/ellipse.gp");

p = [c + a*X/norm2([X, Y]), b*Y/norm2([X, Y])];
if(abs((1 - e^2)*p[1]^2 - 2*e^2*rho*p[1] + p[2]^2 - e^2*rho^2) > 1e-50, error("not on it"));
both("printed 2", [e, rho, R, X, Y], e*rho/(1 + e*p[1]/norm2(p)), norm2(p));
