\\ The work of the force (t, t, 1) until T = x, for x = pi/4 + 2 n pi, and the value printed for it.
read("reference/witness/shared/common.gp");
r = 1.6391751105010273; w = 0.505586211437905; T = 19.938501455885554;
work(T) = intnum(t = 0, T, dot([t, t, 1], [-r*w*sin(w*t), r*w*cos(w*t), 0]));
times = vector(4, n, Pi/4 + 2*(n - 1)*Pi);
both("printed 1", [r, w, T], apply(work, times), r*w*sqrt(2)*times);
