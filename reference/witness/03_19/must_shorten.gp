\\ The small pulley goes down by 1, the mass by 3: what the second spring grows by, so that the second rope keeps its
\\ length. It runs from the spring's end, S2 above the floor, up to the pulley and down to the mass.
read("reference/witness/shared/common.gp");

floor_depth = 9; y2 = 1; y3 = 5/2; S2 = 2;
rope(d2, d3, grown) = (floor_depth - S2 - grown - y2 - d2) + (y3 + d3 - y2 - d2);
growth(d2, d3) = my(change = rope(d2, d3, x) - rope(0, 0, 0)); -polcoef(change, 0)/polcoef(change, 1);
case([1, 3], growth(1, 3), -1);
