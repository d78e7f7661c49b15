\\ The top's center of mass, over its points, and the tip.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/top.gp");

p = [alpha*sin(lambda*t), 0, 0];
formula(letters, sum(k = 1, 7, masses[k]*(p + points[k]))/m, p, p + l*axis);
