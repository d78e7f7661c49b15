#include "reference/make/extrapolation.hpp"
#include "reference/make/taylor.hpp"

// A massless bar about the origin, a mass m at r, and at s a spring of constant c and rest length ell with
// its foot at (s, -h). Position of the mass at time t after its release at the angle theta0 with angular
// speed w0.
namespace oddity::truth {

namespace swing_03_23 {

struct Bar {
  Number m, r, s, c, h, g, ell, theta0, w0;
  explicit Bar(const std::vector<double>& in)
      : m(in[0]), r(in[1]), s(in[2]), c(in[3]), h(in[4]), g(in[5]), ell(in[6]), theta0(in[7]), w0(in[8]) {}
};

/// The spring's squared length is h^2 + 2 s^2 + 2 s (h sin - s cos); half its derivative is s (s sin + h
/// cos).
Numbers by_taylor(const std::vector<double>& in, Precision digits) {
  const Bar b(in);
  const Number inertia = b.m * b.r * b.r, torque = b.m * b.g * b.r;
  const auto rhs = [&](const auto& x, const auto&) {
    const auto C = cos(x[0]), S = sin(x[0]);
    const auto length = sqrt((b.h * b.h + 2 * b.s * b.s) + (2 * b.s * b.h) * S - Number(2 * b.s * b.s) * C);
    const auto arm = (b.s * b.s) * S + (b.s * b.h) * C;
    return std::vector{x[1], (-torque * C - b.c * (arm - b.ell * arm / length)) / inertia};
  };
  const Number theta = solve_taylor(rhs, {b.theta0, b.w0}, 0, Number(in[9]), digits + 4)[0];
  return {b.r * cos(theta), b.r * sin(theta)};
}

/// The mass in the plane, constrained by |x| = r, differentiated twice; the spring acts through the lever
/// s/r.
Numbers by_extrapolation(const std::vector<double>& in, Precision digits) {
  const Bar b(in);
  const Number lever = b.s / b.r;
  const auto rhs = [&](const Numbers& x, const Number&) {
    const Number dx = lever * x[0] - b.s, dy = lever * x[1] + b.h;
    const Number pull = -lever * b.c / b.m * (1 - b.ell / sqrt(dx * dx + dy * dy));
    const Number fx = pull * dx, fy = pull * dy - b.g;
    const Number hold = (x[2] * x[2] + x[3] * x[3] + fx * x[0] + fy * x[1]) / (x[0] * x[0] + x[1] * x[1]);
    return Numbers{x[2], x[3], fx - hold * x[0], fy - hold * x[1]};
  };
  const Number C = cos(b.theta0), S = sin(b.theta0), v = b.r * b.w0;
  Numbers x{b.r * C, b.r * S, -v * S, v * C};
  x = solve_extrapolation(rhs, x, 0, Number(in[9]), digits + 6);
  x.resize(2);
  return x;
}

}  // namespace swing_03_23

Truth truth_03_23_swing() {
  using namespace swing_03_23;
  std::vector<std::vector<double>> rows;
  const double stiff = 98100;
  for (double t : {1.0, 2.0, 3.0, 4.0}) {
    rows.push_back({1, 1, 0.5, 98.1, 0.8, 9.81, 1, 0.3, 0, t});
    rows.push_back({1, 1, 0.5, 98.1, 0.8, 9.81, 1, 1.2, 0, t});
    rows.push_back({2, 0.75, 1, 20, 0.5, 9.81, 0.75, 0.1, 1, t});
    for (double c : {20.0, 50.0, 100.0, 300.0, 1000.0, 2500.0})
      rows.push_back({1, 1, 0.5, c, 0.8, 9.81, 1, 0.3, 0, t});
  }
  for (double t : {0.25, 0.5, 0.75, 1.0})
    rows.push_back({1, 1, 0.5, stiff, 0.8, 9.81, 0.8 + 1 * 9.81 * 1 / (stiff * 0.5), 0.3, 0, t});
  return {
      "position of the mass on a bar with a standing spring t after its start, x = r (cos theta, sin theta)",
      "m r^2 theta'' = -m g r cos theta - c (1 - ell/d) s (s sin theta + h cos theta), d^2 = s^2 (cos theta "
      "- 1)^2 + (h + s sin theta)^2",
      {"m", "r", "s", "c", "h", "g", "ell", "theta0", "w0", "t"},
      {{"x", "m"}, {"y", "m"}},
      rows,
      "Taylor series of the equation of the angle",
      by_taylor,
      "extrapolated midpoint rule on the Cartesian equations with one constraint",
      by_extrapolation,
      "the first route, the remainders bounded",
      by_taylor};
}

}  // namespace oddity::truth
