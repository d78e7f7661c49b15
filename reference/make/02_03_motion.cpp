#include <array>
#include <cmath>

#include "reference/make/routes.hpp"

// The curve lies on the unit sphere, its polar angle is t and its colatitude phi has cot(phi) = t. The second
// route knows the positions alone.
namespace oddity::truth {

namespace {

using Vector = std::array<Number, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Number dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Numbers by_angles(const std::vector<double>& in, int) {
  const Number t = in[0], d = 1 + t * t;
  const Number phi_dot = -1 / d, phi_ddot = 2 * t / (d * d), sine = 1 / sqrt(d), cosine = t * sine;
  return {atan2(Number(1), t),       sine, -phi_dot, 0, 2 * phi_dot * cosine, t / d - phi_ddot,
          -phi_dot * phi_dot - 1 / d};
}

Vector position(const Number& t) {
  const Number d = sqrt(1 + t * t);
  return {cos(t) / d, sin(t) / d, t / d};
}

/// First and second derivative by central differences of steps 1/32, 1/64, ..., extrapolated (errors in h^2).
std::array<Vector, 2> derivatives(const Number& t) {
  constexpr int levels = 11;
  std::vector<std::array<Vector, 2>> row;
  for (int k = 0; k < levels; ++k) {
    const Number h = ldexp(Number(1), -5 - k);
    const Vector ahead = position(t + h), here = position(t), behind = position(t - h);
    std::vector<std::array<Vector, 2>> next(1);
    for (std::size_t i = 0; i < 3; ++i) {
      next[0][0][i] = (ahead[i] - behind[i]) / (2 * h);
      next[0][1][i] = (ahead[i] - 2 * here[i] + behind[i]) / (h * h);
    }
    for (int j = 1; j <= k; ++j) {
      std::array<Vector, 2> better = next.back();
      for (std::size_t d = 0; d < 2; ++d)
        for (std::size_t i = 0; i < 3; ++i)
          better[d][i] +=
              (better[d][i] - row[static_cast<std::size_t>(j - 1)][d][i]) / (ldexp(Number(1), 2 * j) - 1);
      next.push_back(better);
    }
    row = std::move(next);
  }
  return row.back();
}

Numbers by_positions(const std::vector<double>& in, int) {
  const Number t = in[0];
  const Vector r = position(t);
  const Number flat = sqrt(r[0] * r[0] + r[1] * r[1]);
  const Vector P{-r[1] / flat, r[0] / flat, 0}, Q = cross(r, P);
  const auto [v, a] = derivatives(t);
  return {2 * asin(sqrt(r[0] * r[0] + r[1] * r[1] + (r[2] - 1) * (r[2] - 1)) / 2),
          dot(v, P),
          dot(v, Q),
          dot(v, r),
          dot(a, P),
          dot(a, Q),
          dot(a, r)};
}

}  // namespace

Truth truth_02_03_motion() {
  std::vector<std::vector<double>> rows;
  for (double t : {-1e8, -50.0, -3.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0, 7.0, 50.0, 1e8}) rows.push_back({t});
  return {
      "motion along the spherical helix at t: colatitude, velocity and acceleration in the frame {P, Q, R}",
      "r = (cos t, sin t, t)/sqrt(1 + t^2) = R, P = k x R/|k x R|, Q = R x P",
      {"t"},
      {{"phi", "rad"}, {"v_P", "1"}, {"v_Q", "1"}, {"v_R", "1"}, {"a_P", "1"}, {"a_Q", "1"}, {"a_R", "1"}},
      rows,
      "spherical coordinates with theta = t, phi = arccot(t)",
      by_angles,
      "central differences of the position, extrapolated, and the chord to the pole",
      by_positions};
}

}  // namespace oddity::truth
