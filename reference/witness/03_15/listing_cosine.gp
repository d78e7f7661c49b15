\\ The component of (c, 0, 0) along the rod at the time t, and the listing's `aux[3]*Cos(aux[0]*time)`.
read("reference/witness/shared/common.gp");
c = 2.789736490559292; w = -0.17464879636491912; s = 4.111577432318837; t = 2.048476084334677;
D = [cos(Pi*t/4), sin(Pi*t/4), 1]/sqrt(2);
both("printed 1", [c, w, s, t], dot([c, 0, 0], D), c/sqrt(2)*cos(t/sqrt(2)));
