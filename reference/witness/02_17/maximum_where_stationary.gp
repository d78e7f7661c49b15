\\ The work of the force (1, 1, 1) over a circle at omega T = 5 pi/4, where its rate is zero too: the second
\\ derivative there, and the sign that a maximum would give it.
read("reference/witness/shared/common.gp");
r = 3/2; w = 2; T = 5*Pi/4/w;
work(T) = intnum(t = 0, T, dot([1, 1, 1], [-r*w*sin(w*t), r*w*cos(w*t), 0]));
power(t) = r*w*(cos(w*t) - sin(w*t));
if(abs(power(T)) > 1e-50, error("not stationary"));
bend = (work(T + 1/1000) - 2*work(T) + work(T - 1/1000))*10^6;
case([r, w, T], sign(bend), -1);
