\\ The squared speed of a point b of a wire that moves and turns.
read("reference/witness/shared/common.gp");
u = [3/2, -2/3]; w = 7/5; th = 4/5; b = [6/5, -1/2];
turn(s) = [cos(s), -sin(s); sin(s), cos(s)];
velocity = rate(s -> u*s + (turn(th + w*s)*b~)~, 0);
D = rate(s -> (turn(s)*b~)~, th);
printed = dot(u, u) + w^2*dot(b, b);
formula(concat(concat(u, b), [w, th]), dot(velocity, velocity), printed, printed + 2*w*dot(u, D));
