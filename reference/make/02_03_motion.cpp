#include <cmath>

#include "reference/make/even_limit.hpp"

// The curve lies on the unit sphere; its polar angle is t and its colatitude phi has cot(phi) = t. The second
// route uses only the positions.
namespace oddity::truth {

namespace motion_02_03 {

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

Numbers by_positions(const std::vector<double>& in, int digits) {
  const Number t = in[0];
  const Vector r = position(t);
  const Number flat = sqrt(r[0] * r[0] + r[1] * r[1]);
  const Vector P{-r[1] / flat, r[0] / flat, 0}, Q = cross(r, P);
  const Numbers motion = even_limit(
      [&](const Number& h) -> Numbers {
        const Vector ahead = position(t + h), behind = position(t - h);
        const Vector v = scaled(1 / (2 * h), sum(ahead, scaled(-1, behind)));
        const Vector a = scaled(1 / (h * h), sum(sum(ahead, behind), scaled(-2, r)));
        return {dot(v, P), dot(v, Q), dot(v, r), dot(a, P), dot(a, Q), dot(a, r)};
      },
      digits);
  Numbers all{2 * asin(sqrt(r[0] * r[0] + r[1] * r[1] + (r[2] - 1) * (r[2] - 1)) / 2)};
  all.insert(all.end(), motion.begin(), motion.end());
  return all;
}

}  // namespace motion_02_03

Truth truth_02_03_motion() {
  using namespace motion_02_03;
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
      by_positions,
      "the first route",
      by_angles};
}

}  // namespace oddity::truth
