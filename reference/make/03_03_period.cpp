#include "reference/make/routes.hpp"

// The period of a bound orbit. First route: 2 pi a sqrt(a/(G M)), a = G M/(-2 E), E the energy of the start.
// The second one uses neither a nor the apsides: with h = r0^2 theta0' the path in u = 1/r is
//   u = G M/h^2 + A cos(phi) + B sin(phi),   A = u(0) - G M/h^2,   B = u'(0) = -r0'/h,
// with phi = theta - theta0. T is the integral of 1/(h u^2) over a turn, by the trapezoidal rule (converging
// geometrically).
namespace oddity::truth {

namespace period_03_03 {

Numbers by_kepler(const std::vector<double>& in, int) {
  const Number mu = Number(in[0]) * Number(in[1]), r = in[2], v = in[3], w = in[5];
  const Number a = mu / (2 * mu / r - v * v - r * r * w * w);
  return {2 * pi() * a * sqrt(a / mu)};
}

Numbers by_turn(const std::vector<double>& in, int digits) {
  const Number mu = Number(in[0]) * Number(in[1]), r = in[2], h = r * r * Number(in[5]);
  const Number mean = mu / (h * h), A = 1 / r - mean, B = -Number(in[3]) / h;
  Number sum = 0, before = 0;
  for (int n = 64; n < 1 << 20; n *= 2) {
    sum = 0;
    for (int k = 0; k < n; ++k) {
      const Number phi = 2 * pi() * k / n, u = mean + A * cos(phi) + B * sin(phi);
      sum += 1 / (abs(h) * u * u);
    }
    sum *= 2 * pi() / n;
    if (abs(sum - before) <= abs(sum) * pow(Number(10), -digits / 2 - 4)) break;
    before = sum;
  }
  return {sum};
}

}  // namespace period_03_03

Truth truth_03_03_period() {
  using namespace period_03_03;
  constexpr double four_pi_squared = 39.47841760435743;
  return {"period of the orbit through (r0, theta0) with (r0', theta0')",
          "2 pi a^(3/2) / sqrt(G M), a = semi-major axis",
          {"G", "M", "r0", "r0_dot", "theta0", "theta0_dot"},
          {{"T", "yr"}},
          {{four_pi_squared, 1, 1, 0.09375, 1.75, 6.25},
           {four_pi_squared, 1, 1.75, 1.7862, -2, 0.8943},
           {four_pi_squared, 2, 1.75, -3.28124, 0.75, 0.409303}},
          "semi-major axis from the energy",
          by_kepler,
          "integral of the time over a turn, dt = d theta/(h u^2), by the trapezoidal rule",
          by_turn,
          "the first route",
          by_kepler};
}

}  // namespace oddity::truth
