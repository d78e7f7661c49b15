\\ The root's argument at a node of the listing, cos psi - cos(pi/6), and with the angle subtracted.
read("reference/witness/shared/common.gp");
angle = 0.0005113269195295886;
both("printed 1", angle, 2*sin((Pi/6 + angle)/2)*sin((Pi/6 - angle)/2), cos(angle) - Pi/6, cos(angle) - cos(Pi/6));
