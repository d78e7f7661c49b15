#include "reference/make/03_07_bead.hpp"

// The time at which the bead released at q0 reaches the origin. The first route keeps the singular integrand,
// written in the distance x = q0 - q from its end to avoid cancellation there.
namespace oddity::truth {

namespace arrival_03_07 {

Numbers by_quadrature(const std::vector<double>& in, int digits) {
  const Number q0 = in[0], g = in[1];
  const auto from_the_end = [&](const Number& x) -> Number {
    const Number q = q0 - x;
    return sqrt((1 + 4 * q * q + 9 * q * q * q * q) / (2 * g * x * (3 * q0 * q0 - 3 * q0 * x + x * x)));
  };
  return {integral(from_the_end, 0, q0, digits)};
}

Numbers by_taylor(const std::vector<double>& in, int digits) {
  const Number q0 = in[0], g = in[1];
  TaylorProblem bead(HeldBead{g}, 6);
  Numbers s{q0, q0 * q0, q0 * q0 * q0, 0, 0, 0};
  const Number stride = sqrt((1 + 4 * q0 * q0 + 9 * q0 * q0 * q0 * q0) / (2 * g * q0)) / 32;
  Number early = 0, t = 0;
  for (; s[0] > 0; t += stride) {
    early = t;
    s = bead.solve(s, t, Number(t + stride), digits);
  }
  Number late = t;
  for (int newton = 0; newton < 60; ++newton) {
    Number next = t - s[0] / s[3];
    if (abs(Number(next - t)) < pow(Number(10), -digits) * t) return {next};
    (s[0] > 0 ? early : late) = t;
    if (!(early < next && next < late)) next = (early + late) / 2;
    s = bead.solve(s, t, next, digits);
    t = next;
  }
  throw std::runtime_error("Newton's method does not find the bead at the origin");
}

Numbers by_time(const std::vector<double>& in, Precision digits) {
  const Number q0 = in[0], g = in[1];
  const auto rhs = [&](const auto&, const auto& u) { return std::vector{seconds_per_u(q0, g, u)}; };
  return solve_taylor(rhs, {Number(0)}, 0, 1, digits + 4);
}

}  // namespace arrival_03_07

Truth truth_03_07_arrival() {
  using namespace arrival_03_07;
  std::vector<std::vector<double>> rows;
  for (double q0 : {0.25, 1.0, 3.0})
    for (double g : {1.0, 4.0, 9.81}) rows.push_back({q0, g});
  return {
      "time from rest at (q0, q0^2, q0^3) to the origin on the curve (q, q^2, q^3), gravity along -z",
      "int_0^q0 sqrt((1 + 4 q^2 + 9 q^4) / (2 g (q0^3 - q^3))) dq",
      {"q0", "g"},
      {{"T", "s"}},
      rows,
      "double-exponential quadrature of the singular integrand from its end",
      by_quadrature,
      "Newton's method, kept in a bracket, on Taylor series of the Cartesian equations with two multipliers",
      by_taylor,
      "Taylor series of the time over u, q = q0 (1 - u^2), their remainders bounded",
      by_time};
}

}  // namespace oddity::truth
