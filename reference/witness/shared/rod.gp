\\ The mass on the turning rod of 3.15.
L = 4; c = 1; m = 1; K = 10;
\\ lambda'' from T = m/2 (lambda'^2 + w^2 lambda^2/2), V = K/2 (r - l)^2,
\\ r^2 = lambda^2 - sqrt(2) c cos(wt) lambda + c^2
spring(t, s, w) = sqrt(s^2 - sqrt(2)*c*cos(w*t)*s + c^2);
rod(w = Pi/4, l = spring(0, L/2, 0), K = K) = {
  (t, z) -> [z[2], w^2/2*z[1] - K/m*(1 - l/spring(t, z[1], w))*(z[1] - c*cos(w*t)/sqrt(2))];
}
