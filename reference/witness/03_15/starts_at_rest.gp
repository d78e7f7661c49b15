\\ The velocity in space of a mass at rest on the turning rod, lambda = sqrt(2) b.
read("reference/witness/shared/common.gp");
b = 7/5;
place(t) = b*[cos(Pi*t/4), sin(Pi*t/4), 1];
formula(b, rate(place, 0), [0, 0, 0], [0, Pi*b/4, 0]);
