\\ The middle of the apsides of the mirror image, whose r(0) and r(pi) are the orbit's r(pi) and r(0).
read("reference/witness/shared/common.gp");
e = 0.5238103818908687; rho = 0.26155672715779704; R = 0.2806678757692659; X = 0.27426288519143005; Y = 0.059618170848362365;
read("reference/witness/shared/ellipse.gp");

both("printed 1", [e, rho, R, X, Y], [(r(Pi) - r(0))/2, 0], [-c, 0]);
