\\ The rate of the vertical angular momentum about the moving tip, which is printed as constant.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/top.gp");

formula(letters, moment(a, [0, 0, 0])[3], 0, m*l*alpha*lambda^2*sin(lambda*t)*cos(th)*sin(phi));
