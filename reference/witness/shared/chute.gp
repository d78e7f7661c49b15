\\ A ball in the tilted chute of 3.13.
g = 981/100; k = 1/5;
\\ x'' in the chute cos(theta) x3 + sin(theta) x1 = const. - sqrt(R^2 - x2^2), with the friction f against the velocity.
acceleration(th, R, x2, v, f) = {
  my(q = sqrt(R^2 - x2^2), n = [sin(th), -x2/q, cos(th)], bend = -R^2/q^3*v[2]^2, free = [0, 0, -g] - f*v);
  free + n*(-bend - dot(n, free))/dot(n, n);
}
