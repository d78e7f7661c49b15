\\ The force on the mass, m3 y3''. Corrected: with the inertia of the pulley between spring and mass.
read("reference/witness/shared/common.gp");
m2 = 0.6159613185016284; m3 = 0.8481525220820867; I1 = 1.983421886150618; I2 = 1.0517389157833532;
R1 = 2.2396701799884835; R2 = 1.371025780323703; c1 = 0.6409590471975845; c2 = 2.789855944777466;
L1 = 1.6899042574073286; L2 = 2.4806349335541533; K1 = -0.2205181180126881; K2 = -0.9005605299595569;
g = 0.30506147760661223; y2 = 0.15041914613048388; y3 = 0.2101958649739107;
letters = [m2, m3, I1, I2, R1, R2, c1, c2, L1, L2, K1, K2, g, y2, y3];
read("reference/witness/shared/pulleys.gp");

both("printed 1", letters, m3*N[2], m3*g - pull2, m3*g - pull2 - I2/R2^2*(a[2] - a[1]));
