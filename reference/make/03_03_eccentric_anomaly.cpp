#include "reference/make/routes.hpp"
#include "reference/make/taylor.hpp"

// Kepler's equation E - e sin E = M, 0 <= e < 1, 0 <= M <= pi. As a function of M its root has
// dE/dM = 1/(1 - e cos E), and E(pi) = pi.
namespace oddity::truth {

namespace eccentric_anomaly_03_03 {

Numbers by_bisection(const std::vector<double>& in, int digits) {
  const Number e = in[0], M = in[1];
  Number low = M, high = M + e;
  while (high - low > pow(Number(10), -digits - 6)) {
    const Number middle = (low + high) / 2;
    (middle - e * sin(middle) < M ? low : high) = middle;
  }
  return {between(low, high)};
}

Numbers by_taylor(const std::vector<double>& in, int digits) {
  const Number e = in[0];
  const auto rhs = [&](const auto& x, const auto&) { return std::vector{Number(1) / (1 - e * cos(x[0]))}; };
  return solve_taylor(rhs, {pi()}, pi(), Number(in[1]), digits + 2);
}

}  // namespace eccentric_anomaly_03_03

Truth truth_03_03_eccentric_anomaly() {
  using namespace eccentric_anomaly_03_03;
  return {"eccentric anomaly E of the mean anomaly M",
          "E - e sin E = M",
          {"e", "M"},
          {{"E", "rad"}},
          {{0.5, 1}, {0.9, 0.125}, {0.99, 0.0625}},
          "bisection",
          by_bisection,
          "Taylor series of dE/dM = 1/(1 - e cos E) from M = pi",
          by_taylor,
          "the first route, each sign proved",
          by_bisection};
}

}  // namespace oddity::truth
