\\ The moment of rough friction, 1 N/kg, on a rod of 1 m and 2 kg that turns about its center, slower and slower in
\\ either sense. At rest its direction is 0/0.
read("reference/witness/shared/common.gp");
moment(w) = 2*intnum(s = 0, 1/2, -2*s*(w*s)/abs(w*s));
case([], [moment(1/10^9), moment(-1/10^9)], none);
