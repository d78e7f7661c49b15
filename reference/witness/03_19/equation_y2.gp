\\ The left side of the equation of y2 along Newton's accelerations.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/pulleys.gp");

formula(letters, m2*N[1] + I1/R1^2*N[1] + I2/R2^2*(N[1] - N[2]), m2*g - pull1, m2*g - pull1 + 2*pull2);
