\\ phi'' of a cone that hangs at rest, the Earth not turning: torque over moment of inertia about the vertex, of slices;
\\ as printed, of a point at h/2^(1/3); corrected with L^2 + I/m for L^2.
read("reference/witness/shared/common.gp");
read("reference/witness/shared/cone.gp");

g = 981/100; L = 3*h/4;
torque = intnum(z = 0, h, -(h - z)*g*sin(phi)*Pi*(r*(1 - z/h))^2);
formula([h, r, g, phi], torque/across(h), -g*sin(phi)/(h/2^(1/3)), -g*L*sin(phi)/(L^2 + 3*(h^2 + 4*r^2)/80));
