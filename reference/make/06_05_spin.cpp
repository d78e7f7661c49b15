#include <array>

#include "reference/make/routes.hpp"

// A box of sides a, b, c rests on the edge along x, turned by the angle theta about it. An impulse f along z,
// spread evenly over l0 <= x <= l1 of the edge, changes its angular velocity. The second route integrates
// over the segment, in the box's axes, in which the inertia tensor is diagonal.
namespace oddity::truth {

namespace spin_06_05 {

struct Box {
  Number jx, jy, jz, cosine, sine, l0, l1, f, y, z;

  explicit Box(const std::vector<double>& in) {
    const Number a = in[0], b = in[1], c = in[2], m = in[3], theta = in[4];
    jx = m * (b * b + c * c) / 12, jy = m * (a * a + c * c) / 12, jz = m * (a * a + b * b) / 12;
    cosine = cos(theta), sine = sin(theta);
    l0 = in[5], l1 = in[6], f = in[7];
    y = (b * cosine + c * sine) / 2, z = (b * sine - c * cosine) / 2;
  }
};

/// J^-1 (r x f e_z) at the midpoint, with J in the world's axes and Cramer's rule.
Numbers by_midpoint(const std::vector<double>& in, int) {
  const Box box(in);
  const Number x = (box.l0 + box.l1) / 2;
  const Number yy = box.jy * box.cosine * box.cosine + box.jz * box.sine * box.sine,
               zz = box.jy * box.sine * box.sine + box.jz * box.cosine * box.cosine,
               yz = (box.jy - box.jz) * box.sine * box.cosine, det = yy * zz - yz * yz;
  const Number torque_x = box.y * box.f, torque_y = -x * box.f;
  return {torque_x / box.jx, torque_y * zz / det, -torque_y * yz / det};
}

Numbers by_segment(const std::vector<double>& in, int digits) {
  const Box box(in);
  const auto component = [&](int i) -> Number {
    const auto density = [&, i](const Number& x) -> Number {
      const Number share = box.f / (box.l1 - box.l0);
      const Number own_y = -x * share * box.cosine / box.jy, own_z = x * share * box.sine / box.jz;
      if (i == 0) return box.y * share / box.jx;
      return i == 1 ? Number(own_y * box.cosine - own_z * box.sine)
                    : Number(own_y * box.sine + own_z * box.cosine);
    };
    return integral(density, box.l0, box.l1, digits);
  };
  return {component(0), component(1), component(2)};
}

}  // namespace spin_06_05

Truth truth_06_05_spin() {
  using namespace spin_06_05;
  return {"change of angular velocity of a box, hit evenly along a part of the edge that it stands on",
          "J^-1 (r(M) x f N), M the middle of the segment",
          {"a", "b", "c", "m", "theta", "l0", "l1", "f"},
          {{"wx", "rad/s"}, {"wy", "rad/s"}, {"wz", "rad/s"}},
          {{1, 0.5, 0.75, 2, 0.5, -0.125, 0.5, 3},
           {1, 1, 1, 1, 0.25, 0, 0.5, 1},
           {8, 0.125, 0.25, 1, 1.25, -4, 1, 0.5}},
          "the midpoint, Cramer's rule in the world's axes",
          by_midpoint,
          "double-exponential quadrature over the segment in the box's axes",
          by_segment,
          "the first route",
          by_midpoint};
}

}  // namespace oddity::truth
