\\ The height of a trapezoid's centroid over its side 2, the other one being 1, in parts of its height; the mean of its
\\ corners; and the corners weighted by a third of each triangle's share of the area.
read("reference/witness/shared/common.gp");
width(z) = 2 - z;
centroid = intnum(z = 0, 1, z*width(z))/intnum(z = 0, 1, width(z));
\\ triangles of the areas 2/2 and 1/2: corners at 0, 0, 1 and at 0, 1, 1
formula([2, 1], centroid, (0 + 0 + 1 + 1)/4, (1*1/3 + 1/2*2/3)/(1 + 1/2));
