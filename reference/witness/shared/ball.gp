\\ The damped ball of 3.9, one coordinate of it; its friction a is set before.
flow(t) = exponential([0, 1; -c/m, -a/m]*t);
at(t, p, v) = (flow(t)*[p, v]~)[1];
