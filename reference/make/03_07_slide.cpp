#include "reference/make/03_07_bead.hpp"

// The position at time t of the bead released at q0.
namespace oddity::truth {

namespace slide_03_07 {

Numbers by_taylor(const std::vector<double>& in, Precision digits) {
  const Number q0 = in[0];
  const Numbers start{q0, q0 * q0, q0 * q0 * q0, 0, 0, 0};
  const Numbers s = solve_taylor(HeldBead{Number(in[1])}, start, 0, Number(in[2]), digits + 4);
  return {s[0], s[1], s[2]};
}

Numbers by_energy(const std::vector<double>& in, Precision digits) {
  const Number q0 = in[0], g = in[1];
  const auto rhs = [&](const Numbers& u, const Number&) { return Numbers{1 / seconds_per_u(q0, g, u[0])}; };
  const Number u = solve_extrapolation(rhs, {Number(0)}, 0, Number(in[2]), digits + 4)[0];
  const Number q = q0 * (1 - u * u);
  return {q, q * q, q * q * q};
}

}  // namespace slide_03_07

Truth truth_03_07_slide() {
  using namespace slide_03_07;
  std::vector<std::vector<double>> rows;
  for (const auto& [q0, g] :
       {std::pair{1.0, 1.0}, {1.0, 9.81}, {3.0, 1.0}, {0.25, 1.0}, {0.5, 1.0}, {1.5, 1.0}, {2.0, 1.0}})
    for (double t : {1.0, 2.0, 3.0, 4.0}) rows.push_back({q0, g, t});
  for (double t : {2.24, 2.241}) rows.push_back({1, 1, t});
  return {"position t after rest at (q0, q0^2, q0^3) on the curve (q, q^2, q^3), gravity along -z",
          "r'' = -g k + forces normal to the curve",
          {"q0", "g", "t"},
          {{"x", "m"}, {"y", "m"}, {"z", "m"}},
          rows,
          "Taylor series of the Cartesian equations with two multipliers",
          by_taylor,
          "extrapolated midpoint rule on the energy's first-order equation in u, q = q0 (1 - u^2)",
          by_energy,
          "the first route, the remainders bounded",
          by_taylor};
}

}  // namespace oddity::truth
