\\ The height of the cone's center of mass.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/cone.gp");

both("printed 1", letters, center, h*(1 - 2^(-1/3)), h/4);
