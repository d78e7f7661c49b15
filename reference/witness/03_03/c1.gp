\\ The constant c1 of V(theta) = c0 sin(theta) + c1 cos(theta) - (GM/h)^2, from two later places of the path.
read("reference/witness/shared/common.gp");
G = 4.536575079642092; M = 0.7675062878995358; r0 = 1.0512707674356148; rd = -0.6573856336619763;
th = -0.44578757979987804; thd = 2.122789179740182; t = 2.1532911816173623;
letters = [G, M, r0, rd, th, thd, t];
read("reference/witness/shared/kepler.gp");
read("reference/witness/shared/kepler_constants.gp");

both("printed 1", letters, c[2], bracket*cos(th) - slope*sin(th));
