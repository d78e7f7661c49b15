\\ A particle on the hill of 3.11.
g = 1; a1 = 2; a2 = 1;
\\ x'' on the hill x3 = -x1^2/a1^2 - x2^2/a2^2, where x'' + (0, 0, g) is along the normal n.
acceleration(p, v) = {
  my(n = [2*p[1]/a1^2, 2*p[2]/a2^2, 1], bend = 2*v[1]^2/a1^2 + 2*v[2]^2/a2^2);
  n*(g - bend)/dot(n, n) - [0, 0, g];
}
