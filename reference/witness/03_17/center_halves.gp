\\ The volume of the cone above its center of mass.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/cone.gp");

formula([h, r], volume(center), volume()/2, 27/64*volume());
