// Exercise 5.15: the curl applied n times, by the permutation tensor e:
//   ((curl)^n f)_i = e(i jn kn) e(kn j(n-1) k(n-1)) ... e(k2 j1 k1) f(k1, j1 ... jn)
// Every published index expression is evaluated as printed, from derivatives along the axes, and compared
// with curls nested by dual numbers along a randomly rotated frame. The quantity's reference is the closed
// form for plane waves, whose curl is k x p cos.

#include "chapters/05_fluids_and_gases/15_repeated_curl/repeated_curl.hpp"

namespace oddity {

namespace ex05_15 {

using namespace fields;

constexpr auto parameters = [] {
  std::array<Parameter, 6> all{
      {{"n", most_curls, "", "how often the curl is applied, at most", 1, most_curls, whole_number}}};
  for (std::size_t i = 0; i < 5; ++i) all[1 + i] = field_parameters[i];
  return all;
}();

Findings study(const Parameters& p, const Reference& truth) {
  return {claims(Random(p["seed"])), quantities(At(p), p["n"], truth)};
}

}  // namespace ex05_15

Exercise exercise_5_15() {
  using namespace ex05_15;
  return {
      "Repeated curl in index notation",
      "Write $(\\nabla\\times)^n\\mathbf f$ with the permutation tensor $e_{ijk}$. Below $f_{m,jl}$ is the "
      "derivative of $f_m$ with respect to $x_j$ and $x_l$.",
      parameters,
      {},
      study,
      proofs};
}

}  // namespace oddity
