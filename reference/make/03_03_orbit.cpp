#include <type_traits>

#include "reference/make/routes.hpp"
#include "reference/make/taylor.hpp"
#include "reference/make/universal_kepler.hpp"

// r'' = -G M r/|r|^3 from a start in polar coordinates, by Kepler's equation in universal variables.
namespace oddity::truth {

namespace orbit_03_03 {

struct Start {
  Number mu, r0, x, y, vx, vy;
};

Start start_of(const std::vector<double>& in) {
  const Number r0 = in[2], radial = in[3], theta = in[4], transverse = r0 * Number(in[5]);
  const Number c = cos(theta), s = sin(theta);
  return {Number(in[0]) * Number(in[1]), r0, r0 * c, r0 * s, radial * c - transverse * s,
          radial * s + transverse * c};
}

Numbers by_kepler(const std::vector<double>& in, Precision digits) {
  const Start a = start_of(in);
  return by_universal_kepler(a.mu, {a.x, a.y, a.vx, a.vy}, in[6], digits);
}

/// The time nearest to zero at which an ellipse is at the same point as at t: t less whole periods, by the
/// third law. For other orbits, t itself, and in double, where both routes would have the period's rounding.
Number within_a_turn(const Start& a, const Number& t) {
  if (std::is_same_v<Number, double>) return t;
  const Number axis = 1 / (2 / a.r0 - (a.vx * a.vx + a.vy * a.vy) / a.mu);
  if (!(axis > 0)) return t;
  const Number period = 2 * pi() * axis * sqrt(axis / a.mu);
  return t - round(Number(t / period)) * period;
}

Numbers by_taylor(const std::vector<double>& in, Precision digits) {
  const Start a = start_of(in);
  const auto rhs = [&](const auto& q, const auto&) {
    const auto square = q[0] * q[0] + q[1] * q[1];
    const auto pull = -a.mu / (square * sqrt(square));
    return std::vector{q[2], q[3], pull * q[0], pull * q[1]};
  };
  const Numbers end = solve_taylor(rhs, {a.x, a.y, a.vx, a.vy}, 0, within_a_turn(a, in[6]), digits + 4);
  return {end[0], end[1]};
}

}  // namespace orbit_03_03

Truth truth_03_03_orbit() {
  using namespace orbit_03_03;
  constexpr double four_pi_squared = 39.47841760435743;
  std::vector<std::vector<double>> orbits{{four_pi_squared, 1, 1, 0.09375, 1.75, 6.25},
                                          {four_pi_squared, 1, 1.75, 1.7862, -2, 0.8943},
                                          {four_pi_squared, 2, 1.75, -3.28124, 0.75, 0.409303}};
  for (double theta0_dot : {5.95, 4.45, 2.0, 1.0, 0.63})
    orbits.push_back({four_pi_squared, 1, 1, 0.09375, 1.75, theta0_dot});
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
          "Kepler's equation in universal variables",
          by_kepler,
          "Taylor series of the Cartesian equation of motion, whole periods left out",
          by_taylor,
          "the first route, each sign proved and the rest of each series bounded",
          by_kepler};
}

}  // namespace oddity::truth
