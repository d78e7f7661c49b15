// Exercise 7.1: how much more full elimination (every column cleared below and above its pivot) costs than
// forward elimination with back substitution. The prices of a multiplication, an addition and a division are
// mu, alpha, delta. The book clears crosswise, row_i <- a_kk row_i - a_ik row_k, which costs 2 mu + alpha per
// entry. The counts are measured by elimination on counting numbers, never taken from a formula. They are
// compared exactly, as coefficients of mu, alpha and delta. Arithmetic modulo a prime shows that the
// eliminations are right.

#include "chapters/07_linear_algebra/01_cost_of_elimination/cost_of_elimination.hpp"
#include "chapters/inputs.hpp"

namespace oddity {

namespace ex07_01 {

constexpr auto parameters =
    together(std::array{Parameter{"n", 6, "", "unknowns of the system", 2, 8, whole_number},
                        Parameter{"N", 32, "", "unknowns of the larger system", 16, 96, whole_number},
                        Parameter{"seed", 1, "", "seed of the random systems", 0, 1e9, whole_number}},
             numbers<12>(entries_of_own, {1.3, 0.7, -0.2, 1.7, 1.1, 0.9, 0.4, 3.1, 2.7, 1.3, -0.3, 2.9}, "",
                         "entry of an augmented matrix that you choose", 1e30));

Findings study(const Parameters& p, const Reference& truth) {
  const Random random(p["seed"]);
  Quantity large = solution("larger_system", static_cast<std::size_t>(p["N"]), true, random);
  large.add(
      Breakdown{"Crosswise clearing never divides, and so squares the size of the entries column by column. "
                "Within the @2 columns of this system they are out of the range of a double. Division by the "
                "pivot keeps their size.",
                "crosswise, forward and back",
                53,
                Outcome::non_finite,
                "pivoted, LU, rows exchanged",
                0,
                {p["N"]}});
  return {
      claims(random),
      in_operations({solution("system", static_cast<std::size_t>(p["n"]), false, random), large,
                     own_solution(p, truth)}),
      roots(),
      R"(The method and the conclusion are right; {{diagonal entries above the pivot|the count of full elimination is short by $\mu n(n-1)/2$}}, {{lost additions|a difference of two counts loses additions}}, and {{no exchange of rows|a zero pivot is left out}}.)"};
}

}  // namespace ex07_01

Exercise exercise_7_1() {
  using namespace ex07_01;
  return {"Forward and full elimination",
          "An augmented $n\\times(n+1)$ matrix is made diagonal by clearing every column below *and above* "
          "its pivot. How many multiplications ($\\mu$), additions ($\\alpha$) and divisions ($\\delta$) is "
          "that, and is it ever cheaper than forward elimination with back substitution?",
          parameters,
          {},
          study,
          proofs};
}

}  // namespace oddity
