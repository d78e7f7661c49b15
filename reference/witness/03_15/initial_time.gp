\\ The place of lambda = 2 at t = 1, and with a clock set to zero.
read("reference/witness/shared/common.gp");
place(t) = 2*[cos(Pi*t/4), sin(Pi*t/4), 1]/sqrt(2);
both("printed 1", [], place(1), place(0));
