\\ The generalized force on y2, minus the slope of the potential energy.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/pulleys.gp");

formula(letters, F[1], m2*g - pull1, m2*g - pull1 + 2*pull2);
