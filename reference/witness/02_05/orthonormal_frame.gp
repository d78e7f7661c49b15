\\ The squared lengths of D, D' and D x D' for the axis D = (cos t, sin t, t)/sqrt(1 + t^2); unit vectors have 1.
\\ Corrected, D' is divided by its length.
read("reference/witness/shared/common.gp");
t = 7/10;
D(t) = [cos(t), sin(t), t]/sqrt(1 + t^2);
U = [D(t), rate(D, t)/norm2(rate(D, t))]; U = concat(U, [cross(U[1], U[2])]);
P = [D(t), rate(D, t), cross(D(t), rate(D, t))];
formula(t, [1, 1, 1], apply(u -> dot(u, u), P), apply(u -> dot(u, u), U));
