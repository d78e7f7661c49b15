\\ q' of the bead, from rest at q = 1 with g = 1, when it is at the origin; and a little later, by which it should have
\\ decreased and has grown.
read("reference/witness/shared/common.gp");
slide(t, z) = my(q = z[1], u = z[2]); [u, -dot([1, 2*q, 3*q^2], [0, 2, 6*q]*u^2 + [0, 0, 1])/(1 + 4*q^2 + 9*q^4)];
z = follow(slide, [1, 0], 2, 40);
t = solve(t = 0.1, 0.4, follow(slide, z, t, 4)[1]);
least = follow(slide, z, t, 4)[2];
if(follow(slide, z, t + 1/10, 6)[2] <= least, error("it decreases"));
one("corrected 2", [], least, none);
