\\ The curve of 2.7 on the unit sphere.
r(t) = [(1 - t^2)*cos(Pi*t), (1 - t^2)*sin(Pi*t), t^2]/sqrt((1 - t^2)^2 + t^4);
