#include "reference/make/taylor.hpp"

// A disk of radius r on an upright pipe. theta and psi both turn it about the vertical, so only a mark on its
// rim shows the motion, at the angle theta + psi. Its angular momentum about the vertical is constant. The
// second route turns a rigid body by its quaternion under Euler's equations, with moments over mass of r^2/4
// across and r^2/2 about the axis.
namespace oddity::truth {

namespace upright_03_21 {

Numbers by_momentum(const std::vector<double>& in, int) {
  const Number r = in[0], angle = Number(in[1]) + (Number(in[2]) + in[3]) * in[4];
  return {r * cos(angle), r * sin(angle)};
}

Numbers by_quaternion(const std::vector<double>& in, Precision digits) {
  const Number r = in[0], across = r * r / 4, along = r * r / 2, half = Number(in[1]) / 2;
  const Number ratio = (across - along) / across;
  const auto rhs = [&](const auto& x, const auto&) {
    const auto &q = x[0], &i = x[1], &j = x[2], &k = x[3], &a = x[4], &b = x[5], &c = x[6];
    const Number h = Number(1) / 2;
    return std::vector{-(i * a + j * b + k * c) * h,
                       (q * a + j * c - k * b) * h,
                       (q * b + k * a - i * c) * h,
                       (q * c + i * b - j * a) * h,
                       ratio * (b * c),
                       -(ratio * (a * c)),
                       Number(0) * c};
  };
  const Numbers x = solve_taylor(rhs, {cos(half), 0, 0, sin(half), 0, 0, Number(in[2]) + in[3]}, 0,
                                 Number(in[4]), digits + 4);
  return {r * (x[0] * x[0] + x[1] * x[1] - x[2] * x[2] - x[3] * x[3]), 2 * r * (x[1] * x[2] + x[0] * x[3])};
}

}  // namespace upright_03_21

Truth truth_03_21_upright() {
  using namespace upright_03_21;
  std::vector<std::vector<double>> rows;
  for (double t : {2.0, 4.0, 6.0, 8.0}) rows.push_back({0.5, 2, 0.5, 10, t});
  return {"mark on the rim of a disk on an upright pipe",
          "theta' + psi' is constant",
          {"r", "theta", "theta_dot", "psi_dot", "t"},
          {{"x", "m"}, {"y", "m"}},
          rows,
          "momentum about the vertical",
          by_momentum,
          "Taylor series of a rigid body's quaternion and of Euler's equations",
          by_quaternion,
          "the first route",
          by_momentum};
}

}  // namespace oddity::truth
