\\ The force on the small pulley, m2 y2''. Corrected: gravity, the upper rope, and the two sides of the lower one.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/pulleys.gp");

formula(letters, m2*a[1], m2*g - pull1, m2*g - N[3] + pull2 + N[4]);
