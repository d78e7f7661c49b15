\\ A start above the speed of escape, which an ellipse's is below: e of the conic through three places of the path, and
\\ the bound of ellipses.
read("reference/witness/shared/common.gp");
G = 2; M = 1; r0 = 1; rd = 0; th = 3/10; thd = 5/2; letters = [G, M, r0, rd, th, thd];
read("reference/witness/shared/kepler.gp");

place(t) = my(z = follow(fall, start, t, 20)); z[1..2];
\\ r = p - e1 x - e2 y
p = [place(1/10), place(1/5), place(2/5)];
k = matsolve(matrix(3, 3, i, j, if(j == 1, 1, -p[i][j - 1])), vectorv(3, i, norm2(p[i])));
case(letters, sqrt(k[2]^2 + k[3]^2), 1);
