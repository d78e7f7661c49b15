#include "reference/make/extrapolation.hpp"
#include "reference/make/taylor.hpp"

// A ball released in a half cylinder of radius R whose axis falls by H over its length L. With e down the
// axis, n its upward normal and f the horizontal, X = s e + R n + R (sin(phi) f - cos(phi) n).
//   angle   s = u t + g sin(theta) t^2/2,  phi'' = -(g cos(theta)/R) sin(phi).
//   space   X'' = -g k + m N, N = (X - P) - D D.(X - P), m from N.X'' = -|N'|^2, in the directions e, f
//           and n. After a long time the distance along the axis would hide digits of the others.
namespace oddity::truth {

namespace chute_03_13 {

struct Axis {
  Number R, c, s, g;
  explicit Axis(const std::vector<double>& in) : R(in[0]), g(in[3]) {
    const Number L = in[1], H = in[2];
    s = H / L;
    c = sqrt(Number((L - H) * (L + H))) / L;
  }
  Numbers position(const Number& along, const Number& phi) const {
    const Number half = sin(phi / 2), up = 2 * R * half * half;
    return {along * c + up * s, R * sin(phi), up * c - along * s};
  }
};

Numbers by_taylor(const std::vector<double>& in, Precision digits) {
  const Axis axis(in);
  const Number along = axis.g * axis.s, across = axis.g * axis.c;  // gravity's parts
  const auto rhs = [&](const auto& x, const auto& t) {
    const auto &f = x[1], &n = x[2], &vf = x[4], &vn = x[5];
    const auto m = (across * n - vf * vf - vn * vn) / (f * f + n * n);
    return std::vector{x[3], vf, vn, Number(0) * t + along, m * f, m * n - across};
  };
  const Number phi = in[4];
  const Numbers x = solve_taylor(
      rhs, {Number(0), axis.R * sin(phi), -axis.R * cos(phi), Number(in[5]), Number(0), Number(0)}, 0,
      Number(in[6]), digits + 6);
  const Number up = axis.R + x[2];
  return {x[0] * axis.c + up * axis.s, x[1], up * axis.c - x[0] * axis.s};
}

Numbers by_taylor_of_angle(const std::vector<double>& in, Precision digits) {
  const Axis axis(in);
  const Number square = axis.g * axis.c / axis.R, t = in[6];
  const auto rhs = [&](const auto& x, const auto&) { return std::vector{x[1], -square * sin(x[0])}; };
  const Numbers x = solve_taylor(rhs, {Number(in[4]), Number(0)}, 0, t, digits + 6);
  return axis.position(in[5] * t + axis.g * axis.s * t * t / 2, x[0]);
}

Numbers by_angle(const std::vector<double>& in, Precision digits) {
  const Axis axis(in);
  const Number square = axis.g * axis.c / axis.R, t = in[6];
  const auto rhs = [&](const Numbers& x, const Number&) {
    return Numbers{x[1], Number(-square * sin(x[0]))};
  };
  const Numbers x = solve_extrapolation(rhs, {Number(in[4]), Number(0)}, 0, t, digits + 4);
  return axis.position(in[5] * t + axis.g * axis.s * t * t / 2, x[0]);
}

}  // namespace chute_03_13

Truth truth_03_13_chute() {
  using namespace chute_03_13;
  std::vector<std::vector<double>> rows;
  for (double phi : {1.0, 0.0, 1.5, 0.5 * 3.141592653589793, 0.1, 0.5, 1.35})
    for (double t : {1.0, 2.0, 3.0, 4.0}) rows.push_back({1, 5, 3, 9.81, phi, -1, t});
  return {
      "position t after the start in a tilted cylindrical chute, at the angle phi from its lowest line and "
      "with the speed u down the axis",
      "X'' = -g k + a force normal to the cylinder",
      {"R", "L", "H", "g", "phi", "u", "t"},
      {{"x1", "m"}, {"x2", "m"}, {"x3", "m"}},
      rows,
      "Taylor series of the Cartesian equations with the multiplier, along and across the axis",
      by_taylor,
      "uniform acceleration along the axis, extrapolated midpoint rule on the angle about it",
      by_angle,
      "uniform acceleration along the axis, Taylor series of the angle about it, the remainders bounded",
      by_taylor_of_angle};
}

}  // namespace oddity::truth
