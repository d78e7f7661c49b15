\\ The force on the mass, m3 y3''. Corrected: with the inertia of the pulley between spring and mass.
read("reference/witness/shared/common.gp");
m2 = 0.42391999945096076; m3 = 1.354040624843925; I1 = 0.9121745271158328; I2 = 2.5143598927842126;
R1 = 1.4770229104928148; R2 = 0.8115617035727025; c1 = 2.830903939134549; c2 = 2.3685394270292224;
L1 = 1.4458196633261382; L2 = 1.103019069101402; K1 = 0.1074642919043589; K2 = -0.2967621485679729;
g = 1.25807132469335; y2 = 1.2711610075529192; y3 = -0.8667448962566263;
letters = [m2, m3, I1, I2, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3];
read("reference/witness/shared/pulleys.gp");

both("printed 1", letters, m3*N[2], m3*g - pull2, m3*g - pull2 - I2/R2^2*(a[2] - a[1]));
