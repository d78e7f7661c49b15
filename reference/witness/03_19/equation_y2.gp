\\ The left side of the equation of y2 less its right side, along Lagrange's accelerations.
read("reference/witness/shared/common.gp");
m2 = 1.0457868367423149; m3 = 0.747249029125332; I1 = 0.6224470382617169; I2 = 0.9224648024591635;
R1 = 2.2400003394040526; R2 = 2.9111849122238915; c1 = 0.8663195503608998; c2 = 2.577271723288913;
L1 = 0.9633943404012075; L2 = 2.6912004679309875; K1 = 0.5558091245603831; K2 = -1.4516035814122872;
g = 2.798944579044446; y2 = 0.17904410021008776; y3 = -0.8898657156927704;
letters = [m2, m3, I1, I2, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3];
read("reference/witness/shared/pulleys.gp");

left(a) = m2*a[1] + I1/R1^2*a[1] + I2/R2^2*(a[1] - a[2]);
both("printed 1", letters, 0, left(a) - (m2*g - pull1), left(a) - (m2*g - pull1 + 2*pull2));
