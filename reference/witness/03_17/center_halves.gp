\\ The volume of the cone above its center of mass.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/cone.gp");

both("printed 1", letters, volume(center), volume()/2, 27/64*volume());
