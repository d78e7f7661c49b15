#include "reference/make/routes.hpp"
#include "reference/make/taylor.hpp"

// r'' = -G M r/|r|^3 from a start in polar coordinates. The first route solves Kepler's equation in universal
// variables, z = alpha chi^2, alpha = 2/r0 - v0^2/(G M) [Bate, Mueller, White, Fundamentals of Astrodynamics,
// ch. 4]:
//   sqrt(G M) t = chi^3 C3(z) + s chi^2 C2(z) + r0 chi (1 - z C3(z)),   s = r0 r0'/sqrt(G M),
// with Stumpff's functions C2, C3; it holds for ellipse, parabola and hyperbola, and needs no perihelion.
namespace oddity::truth {

namespace {

struct Start {
  Number mu, r0, x, y, vx, vy;
};

Start start_of(const std::vector<double>& in) {
  const Number r0 = in[2], radial = in[3], theta = in[4], transverse = r0 * Number(in[5]);
  const Number c = cos(theta), s = sin(theta);
  return {Number(in[0]) * Number(in[1]), r0, r0 * c, r0 * s, radial * c - transverse * s,
          radial * s + transverse * c};
}

/// C_k(z) = sum over j of (-z)^j / (2j + k)!, k = 2 or 3.
Number stumpff(int k, const Number& z) {
  if (abs(z) > 1) {
    const Number w = sqrt(abs(z)), s = z > 0 ? sin(w) : sinh(w), c = z > 0 ? cos(w) : cosh(w);
    return k == 2 ? Number((1 - c) / z) : Number((w - s) / (z * w));
  }
  Number term = k == 2 ? Number(1) / 2 : Number(1) / 6, sum = term;
  for (int j = 1; abs(term) > pow(Number(10), -65); ++j) {
    term *= -z / ((2 * j + k - 1) * (2 * j + k));
    sum += term;
  }
  return sum;
}

Numbers by_kepler(const std::vector<double>& in, int digits) {
  const Start a = start_of(in);
  const Number root_mu = sqrt(a.mu), t = in[6];
  const Number s = (a.x * a.vx + a.y * a.vy) / root_mu;
  const Number alpha = 2 / a.r0 - (a.vx * a.vx + a.vy * a.vy) / a.mu;
  const auto time = [&](const Number& chi) -> Number {
    const Number z = alpha * chi * chi, c3 = stumpff(3, z);
    return (chi * chi * chi * c3 + s * chi * chi * stumpff(2, z) + a.r0 * chi * (1 - z * c3)) / root_mu;
  };
  Number low = 0, high = 1;
  while (time(high) < t) high *= 2;
  while (high - low > high * pow(Number(10), -digits - 8)) {
    const Number middle = (low + high) / 2;
    (time(middle) < t ? low : high) = middle;
  }
  const Number chi = (low + high) / 2, z = alpha * chi * chi;
  const Number f = 1 - chi * chi * stumpff(2, z) / a.r0, g = t - chi * chi * chi * stumpff(3, z) / root_mu;
  return {f * a.x + g * a.vx, f * a.y + g * a.vy};
}

/// The time next to zero at which an ellipse is where it is at t: t less whole periods, by the third law. The
/// time itself on any other orbit.
Number within_a_turn(const Start& a, const Number& t) {
  const Number axis = 1 / (2 / a.r0 - (a.vx * a.vx + a.vy * a.vy) / a.mu);
  if (!(axis > 0)) return t;
  const Number period = 2 * pi() * axis * sqrt(axis / a.mu);
  return t - round(Number(t / period)) * period;
}

Numbers by_taylor(const std::vector<double>& in, int digits) {
  const Start a = start_of(in);
  const auto rhs = [&](const auto& q, const auto&) {
    const auto square = q[0] * q[0] + q[1] * q[1];
    const auto pull = -a.mu / (square * sqrt(square));
    return std::vector{q[2], q[3], pull * q[0], pull * q[1]};
  };
  const Numbers end = solve_taylor(rhs, {a.x, a.y, a.vx, a.vy}, 0, within_a_turn(a, in[6]), digits + 4);
  return {end[0], end[1]};
}

}  // namespace

Truth truth_03_03_orbit() {
  constexpr double four_pi_squared = 39.47841760435743;
  const std::vector<std::vector<double>> orbits{{four_pi_squared, 1, 1, 0.09375, 1.75, 6.25},
                                                {four_pi_squared, 1, 1.75, 1.7862, -2, 0.8943},
                                                {four_pi_squared, 2, 1.75, -3.28124, 0.75, 0.409303}};
  std::vector<std::vector<double>> rows;
  for (const auto& orbit : orbits)
    for (double t : {0.5, 1.0, 1.5, 2.0}) {
      rows.push_back(orbit);
      rows.back().push_back(t);
    }
  return {"position of a planet t after it was at (r0, theta0) with (r0', theta0')",
          "r'' = -G M r/|r|^3",
          {"G", "M", "r0", "r0_dot", "theta0", "theta0_dot", "t"},
          {{"x", "AU"}, {"y", "AU"}},
          rows,
          "Kepler's equation in universal variables, by bisection",
          by_kepler,
          "Taylor series of the Cartesian equation of motion, whole periods left out",
          by_taylor};
}

}  // namespace oddity::truth
