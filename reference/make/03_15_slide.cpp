#include "reference/make/extrapolation.hpp"
#include "reference/make/routes.hpp"
#include "reference/make/taylor.hpp"

// A mass m on a rod that turns with the speed w about the x3-axis, inclined at 45 degrees to it, starting in
// the (x1, x3)-plane. A spring of stiffness K joins it to (c, 0, 0). It starts at the distance s from the
// foot of the axis, at rest on the rod, with the spring unstretched.
namespace oddity::truth {

namespace slide_03_15 {

struct Rod {
  Number m, c, K, w, s;
  explicit Rod(const std::vector<double>& in) : m(in[0]), c(in[1]), K(in[2]), w(in[3]), s(in[4]) {}
  Number rest_length() const { return sqrt(s * s - sqrt(Number(2)) * c * s + c * c); }
};

/// s'' = w^2 s / 2 - (K / m) (1 - ell / r) (s - p), with the projection p of (c, 0, 0) on the rod, and the
/// spring's length r.
Numbers by_taylor(const std::vector<double>& in, Precision digits) {
  const Rod rod(in);
  const Number ell = rod.rest_length(), K_over_m = rod.K / rod.m, centrifugal = rod.w * rod.w / 2;
  const Number c_squared = rod.c * rod.c, root_half = sqrt(Number(0.5));
  const auto rhs = [&](const auto& x, const auto& t) {
    const auto p = (root_half * rod.c) * cos(rod.w * t);
    const auto r = sqrt(x[0] * x[0] - Number(2) * p * x[0] + c_squared);
    return std::vector{x[1], centrifugal * x[0] - K_over_m * ((x[0] - p) - ell * (x[0] - p) / r)};
  };
  const Number t = in[5];
  const Number s = solve_taylor(rhs, {rod.s, Number(0)}, 0, t, digits + 4)[0] * root_half;
  return {s * cos(rod.w * t), s * sin(rod.w * t), s};
}

/// The mass in space, constrained by x . n1 = x . n2 = 0, differentiated twice. n1 and n2 turn with the rod
/// and are normal to it and to each other.
Numbers by_extrapolation(const std::vector<double>& in, Precision digits) {
  const Rod rod(in);
  const Number ell = rod.rest_length(), h = sqrt(Number(0.5)), w = rod.w, w2 = rod.w * rod.w;
  const auto rhs = [&](const Numbers& s, const Number& t) {
    const Number C = cos(w * t), S = sin(w * t);
    const Number y1 = s[0] - rod.c;
    const Number pull = -rod.K / rod.m * (1 - ell / sqrt(y1 * y1 + s[1] * s[1] + s[2] * s[2]));
    const Number f1 = pull * y1, f2 = pull * s[1], f3 = pull * s[2];
    const Number n1 = -S * f1 + C * f2 - 2 * w * (C * s[3] + S * s[4]) - w2 * (-S * s[0] + C * s[1]);
    const Number n2 =
        h * (C * f1 + S * f2 - f3 + 2 * w * (-S * s[3] + C * s[4]) - w2 * (C * s[0] + S * s[1]));
    return Numbers{s[3], s[4], s[5], f1 + S * n1 - h * C * n2, f2 - C * n1 - h * S * n2, f3 + h * n2};
  };
  const Numbers start{rod.s * h, 0, rod.s * h, 0, rod.s * w * h, 0};
  Numbers x = solve_extrapolation(rhs, start, 0, Number(in[5]), digits + 4);
  x.resize(3);
  return x;
}

}  // namespace slide_03_15

Truth truth_03_15_slide() {
  using namespace slide_03_15;
  const double w = std::atan(1.0);
  std::vector<std::vector<double>> rods{
      {1, 1, 10, w, 2}, {1, 1, 1e4, w, 2}, {1, 1, 10, 1.5 * std::sqrt(20.0), 2}, {0.5, 2, 10, 2, 1}};
  for (double turning : {0.25, 0.75, 1.5, 3.0, 4.25}) rods.push_back({1, 1, 10, turning, 2});
  std::vector<std::vector<double>> rows;
  for (const auto& rod : rods)
    for (double t : {0.5, 1.0, 1.5, 2.0}) {
      rows.push_back(rod);
      rows.back().push_back(t);
    }
  return {"position of a mass on a turning rod, a spring from (c, 0, 0) to it, t after its start at s",
          "s'' = w^2 s / 2 - (K / m) (1 - ell / r) (s - c cos(w t) / sqrt(2)), x = s (cos w t, sin w t, 1) / "
          "sqrt(2)",
          {"m", "c", "K", "w", "s", "t"},
          {{"x1", "m"}, {"x2", "m"}, {"x3", "m"}},
          rows,
          "Taylor series of the equation along the rod",
          by_taylor,
          "extrapolated midpoint rule on the Cartesian equations with two turning constraints",
          by_extrapolation,
          "the first route, the remainders bounded",
          by_taylor};
}

}  // namespace oddity::truth
