\\ The determinant of a, b and a x b for b = -2a: a frame has another one than 0.
read("reference/witness/shared/common.gp");
a = [3, -1, 2]; b = -2*a;
case(concat(a, b), matdet(Mat([a~, b~, cross(a, b)~])), nonzero);
