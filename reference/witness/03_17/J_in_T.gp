\\ I_xx of the cone about its center of mass.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/cone.gp");

both("printed 1", letters, across(center), m*(2*h^2 + 3*r^2)/20, 3*m*(h^2 + 4*r^2)/80);
