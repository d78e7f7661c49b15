#include <cmath>
#include <numbers>

#include "reference/make/routes.hpp"

// With sin(t/2) = k sin(u), k = sin(a/2), the integral is sqrt(2) K(k) [DLMF 19.2.8]. The second route keeps
// the singular integrand, written as 2 sin((a+t)/2) sin((a-t)/2) to avoid cancellation at its end.
namespace oddity::truth {

namespace quarter_period_03_05 {

Numbers by_agm(const std::vector<double>& in, int) {
  return {sqrt(Number(2)) * elliptic_k(sin(Number(in[0]) / 2))};
}

Numbers by_quadrature(const std::vector<double>& in, int digits) {
  const Number a = in[0];
  const auto from_the_end = [&](const Number& x) -> Number {
    return 1 / sqrt(2 * sin(a - x / 2) * sin(x / 2));
  };
  return {integral(from_the_end, 0, a, digits)};
}

}  // namespace quarter_period_03_05

Truth truth_03_05_quarter_period() {
  using namespace quarter_period_03_05;
  std::vector<std::vector<double>> rows;
  for (double a : {std::ldexp(1.0, -10), std::numbers::pi / 6, 1.0, std::numbers::pi / 2, 2.5, 3.0, 3.125})
    rows.push_back({a});
  return {"quarter period of a pendulum let go at rest from the angle a, in units of sqrt(L/2g)",
          "int_0^a dt / sqrt(cos t - cos a) = sqrt(2) K(sin(a/2))",
          {"a"},
          {{"I", "1"}},
          rows,
          "sqrt(2) K(k) by the arithmetic-geometric mean",
          by_agm,
          "double-exponential quadrature of the singular integrand from its end",
          by_quadrature,
          "the first route",
          by_agm};
}

}  // namespace oddity::truth
