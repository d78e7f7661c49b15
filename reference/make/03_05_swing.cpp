#include <numbers>

#include "reference/make/routes.hpp"
#include "reference/make/taylor.hpp"

// theta'' = -(g/L) sin(theta), theta(0) = a, theta'(0) = 0. The solution is theta = 2 asin(k cd(w t, k)), w =
// sqrt(g/L), k = sin(a/2) [DLMF 22.19.2 shifted by a quarter period].
namespace oddity::truth {

namespace swing_03_05 {

Numbers by_jacobi(const std::vector<double>& in, int) {
  const Number a = in[0], L = in[1], g = in[2], t = in[3];
  const Number k = sin(a / 2);
  return {2 * asin(k * jacobi_cd(k, Number(sqrt(g / L) * t)))};
}

Numbers by_taylor(const std::vector<double>& in, Precision digits) {
  const Number minus_g_over_L = -Number(in[2]) / Number(in[1]);
  const auto rhs = [&](const auto& x, const auto&) { return std::vector{x[1], minus_g_over_L * sin(x[0])}; };
  return {solve_taylor(rhs, {Number(in[0]), Number(0)}, 0, Number(in[3]), digits)[0]};
}

}  // namespace swing_03_05

Truth truth_03_05_swing() {
  using namespace swing_03_05;
  std::vector<std::vector<double>> rows;
  for (double a : {std::numbers::pi / 6, 0.125, 0.5, 1.0, 2.0, 3.0})
    for (double t : {2.5, 5.0, 7.5, 10.0}) rows.push_back({a, 1, 9.81, t});
  return {"angle of a pendulum t after it was let go at rest from the angle a",
          "theta'' = -(g/L) sin(theta)",
          {"a", "L", "g", "t"},
          {{"theta", "rad"}},
          rows,
          "Jacobi's elliptic function cd (Boost.Math, descending Landen steps)",
          by_jacobi,
          "Taylor series of the equation of motion",
          by_taylor,
          "the second route, the remainders bounded",
          by_taylor};
}

}  // namespace oddity::truth
