\\ The distance of (-1, 2) from the line through C = (1/2, 1/3) along (3, 4)/5: the least over the line. Printed is
\\ t = N.(P - C) with N = (-4, 3)/5; the corrected one is |t|.
read("reference/witness/shared/common.gp");
C = [1/2, 1/3]; D = [3, 4]/5; N = [-4, 3]/5; P = [2, -1];
apart2(s) = norm2(P - C - s*D);
s = solve(s = -9, 9, (P - C - s*D)*D~);
t = dot(N, P - C);
formula(concat([P, C]), apart2(s), t, abs(t));
