\\ From the cone's vertex to its center of mass.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/cone.gp");

both("printed 1", letters, h - center, h/2^(1/3), 3*h/4);
