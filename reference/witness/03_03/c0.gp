\\ The constant c0 of V(theta) = c0 sin(theta) + c1 cos(theta) - (GM/h)^2, from two later places of the path.
read("reference/witness/shared/common.gp");
G = 0.20007352129543363; M = 2.138431504427629; r0 = 1.3871652641766603; rd = 0.19768737652621576;
th = -0.23916060404592843; thd = 0.47043989812082726; t = 14.913853028421416;
letters = [G, M, r0, rd, th, thd, t];
read("reference/witness/shared/kepler.gp");
read("reference/witness/shared/kepler_constants.gp");

both("printed 1", letters, c[1], bracket*sin(th) + slope*cos(th));
