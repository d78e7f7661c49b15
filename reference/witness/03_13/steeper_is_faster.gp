\\ x1'' on the center line at 60 degrees, less that at 50 degrees, as a sign.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/chute.gp");

along(th) = acceleration(th, 2, 0, [0, 0, 0], 0)[1];
case([g, 50, 60], sign(along(Pi/3) - along(5*Pi/18)), 1);
