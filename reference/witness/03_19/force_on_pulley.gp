\\ The force on the small pulley, m2 y2''. Corrected: gravity, the upper rope, and the two sides of the lower one.
read("reference/witness/shared/common.gp");
m2 = 0.5400918910851014; m3 = 0.5722617976944546; I1 = 2.493710952235386; I2 = 0.6652716849005156;
R1 = 1.0215032138014943; R2 = 2.2347706453522913; c1 = 1.4053357540112263; c2 = 2.2478622812350166;
L1 = 2.167724103635676; L2 = 1.8545595461652709; K1 = -0.29723526663218747; K2 = -0.4616339140864538;
g = 2.3462900267770332; y2 = 0.5299246853862902; y3 = -0.10674197537921401;
letters = [m2, m3, I1, I2, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3];
read("reference/witness/shared/pulleys.gp");

both("printed 1", letters, m2*a[1], m2*g - pull1, m2*g - N[3] + pull2 + N[4]);
