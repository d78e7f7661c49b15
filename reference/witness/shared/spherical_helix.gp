\\ The helix of 2.3 on the unit sphere at the time t, which is set before, and Q, which points to the pole.
r(t) = [cos(t), sin(t), t]/sqrt(1 + t^2);
phi = acos(t/sqrt(1 + t^2));
Q = [-cos(phi)*cos(t), -cos(phi)*sin(t), sin(phi)];
