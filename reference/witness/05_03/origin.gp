\\ The flux of x/|x|^3 out of the cube from -1 to 1, over its six faces; a divergence of zero makes it 0.
read("reference/witness/shared/common.gp");
inner(a) = intnum(b = 0, 1, (1 + a^2 + b^2)^(-3/2));
both("printed 1", [], 24*intnum(a = 0, 1, inner(a)), 0);
