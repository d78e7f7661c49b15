\\ The force on the mass, m3 y3''. Corrected: with the inertia of the pulley between spring and mass.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/pulleys.gp");

formula(letters, m3*N[2], m3*g - pull2, m3*g - pull2 - I2/R2^2*(a[2] - a[1]));
