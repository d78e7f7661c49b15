\\ The middle of the apsides, r(0) and r(pi).
read("reference/witness/shared/common.gp");
e = 0.5238103818908687; rho = 0.26155672715779704; X = 0.08855308298760618; Y = 0.019249315586465223;
read("reference/witness/shared/ellipse.gp");

both("printed 1", [e, rho, X, Y], [(r(0) - r(Pi))/2, 0], [c, 0]);
