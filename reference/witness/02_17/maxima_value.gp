\\ The work of the force (t, t, 1) until x, less its value, both as they are printed; and as they are corrected until
\\ x/omega, for x = pi/4 + 6 pi.
read("reference/witness/shared/common.gp");
r = 3.2769842085451817; w = 3.703159688385661; T = 5.302216414409011;
work(T) = intnum(t = 0, T, dot([t, t, 1], [-r*w*sin(w*t), r*w*cos(w*t), 0]));
x = Pi/4 + 6*Pi;
both("printed 1", [r, w, T], 0, work(w*T) - r*w*(w*T)*sqrt(2), work(x/w) - r/w*(x*sqrt(2) - 1));
