\\ c0 and c1 of V(theta) = c0 sin(theta) + c1 cos(theta) - (GM/h)^2 from two later places of the path, and what is
\\ printed of both.
V(z) = -mu/norm2(z[1..2]);
ends = [follow(fall, start, t/2, 40), follow(fall, start, t, 80)];
c = matsolve(matrix(2, 2, i, j, ends[i][3 - j]/norm2(ends[i][1..2])), vectorv(2, i, V(ends[i]) + (mu/h)^2));
bracket = mu/r0 + mu^2/(r0^4*thd^2); slope = mu*rd/(r0^2*thd);
