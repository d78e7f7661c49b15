\\ The diagonal after full elimination of x2 = 2, x1 = 3, as it stands, crosswise: it is divided by in the end.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/elimination.gp");
M = [0, 1, 2; 1, 0, 3];
M[2,] = M[1,1]*M[2,] - M[2,1]*M[1,];
M[1,] = M[2,2]*M[1,] - M[1,2]*M[2,];
case([2, 3], [M[1,1], M[2,2]], nonzero);
