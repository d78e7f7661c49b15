#include "reference/make/even_limit.hpp"

// w of the rotation by the angle nu t about D = (sin(alpha) cos(Omega t), sin(alpha) sin(Omega t),
// cos(alpha)). The first route differentiates the unit quaternion (cos(theta/2), sin(theta/2) D), the second
// uses only the matrices.
namespace oddity::truth {

namespace angular_velocity_02_05 {

Vector axis(const Number& t, const Number& alpha, const Number& Omega) {
  return {sin(alpha) * cos(Omega * t), sin(alpha) * sin(Omega * t), cos(alpha)};
}

Numbers by_quaternion(const std::vector<double>& in, int) {
  const Number t = in[0], alpha = in[1], Omega = in[2], nu = in[3];
  const Vector D = axis(t, alpha, Omega), D_dot = scaled(Omega, Vector{-D[1], D[0], 0});
  const Number c = cos(nu * t / 2), s = sin(nu * t / 2);
  const Vector v = scaled(s, D), v_dot = sum(scaled(nu / 2 * c, D), scaled(s, D_dot));
  const Number w_dot = -nu / 2 * s;
  return numbers(scaled(2, sum(sum(scaled(c, v_dot), scaled(-w_dot, v)), cross(v, v_dot))));
}

Numbers by_matrices(const std::vector<double>& in, int digits) {
  const auto rotation = [&](const Number& t) {
    const Vector D = axis(t, in[1], in[2]);
    const Number angle = in[3] * t, s = sin(angle), c = cos(angle);
    Matrix R;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) R[i][j] = (1 - c) * D[i] * D[j] + (i == j ? c : Number(0));
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      R[i][j] -= s * D[k];
      R[j][i] += s * D[k];
    }
    return R;
  };
  return angular_velocity(rotation, in[0], digits);
}

}  // namespace angular_velocity_02_05

Truth truth_02_05_angular_velocity() {
  using namespace angular_velocity_02_05;
  return {
      "angular velocity at t of the rotation by nu t about a unit axis at the angle alpha from z, precessing "
      "about z with Omega",
      "Skew(w) = R' R^T",
      {"t", "alpha", "Omega", "nu"},
      {{"w_x", "1"}, {"w_y", "1"}, {"w_z", "1"}},
      {{1, 0.5, 2, 3}, {2.5, 1.5, -3, 0.25}, {0.25, 3, 20, -20}, {1, 0.5, 0.25, 3}},
      "2 q' q* of the unit quaternion",
      by_quaternion,
      "the skew part of R(t + h) R(t - h)^T / 2h, extrapolated",
      by_matrices,
      "the first route",
      by_quaternion};
}

}  // namespace oddity::truth
