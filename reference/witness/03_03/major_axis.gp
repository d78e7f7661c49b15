\\ The period: twice the time from the nearest to the farthest point, where r' is zero; and 2 pi a^(3/2)/sqrt(GM), a the
\\ length of the major axis.
read("reference/witness/shared/common.gp");
G = 0.38522326130197604; M = 1.1698939548190328; r0 = 0.6306340933742324; rd = 0.2588425185010874;
th = 1.029918375127461; thd = 1.4888785811691574; t = 3.1779119538844243;
letters = [G, M, r0, rd, th, thd, t];

mu = G*M; h = r0^2*thd; E = (rd^2 + (r0*thd)^2)/2 - mu/r0;
ends = vecsort(real(polroots(2*E*x^2 + 2*mu*x - h^2)));
q(u) = (ends[1] + ends[2])/2 - (ends[2] - ends[1])/2*cos(u);
\\ r' = sqrt(-2E (r - ends[1])(ends[2] - r))/r, where the root is (ends[2] - ends[1])/2 sin(u)
T = 2*intnum(u = 0, Pi, q(u)/sqrt(-2*E));
both("printed 1", letters, T, 2*Pi*(ends[1] + ends[2])^(3/2)/sqrt(mu));
