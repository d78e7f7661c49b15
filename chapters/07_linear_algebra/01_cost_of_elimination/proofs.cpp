#include "chapters/07_linear_algebra/01_cost_of_elimination/cost_formulas.hpp"
#include "chapters/07_linear_algebra/01_cost_of_elimination/cost_of_elimination.hpp"
#include "chapters/provable_claims.hpp"
#include "solvers/counted.hpp"

namespace oddity {

namespace ex07_01 {

namespace {

using Recorded = CostOf<Expression>;

/// For all n.
Lemma equal_costs(std::string reading, const Recorded& left, const Expressions& right) {
  return {.name = std::move(reading),
          .letters = "(n : R)",
          .follows = equal({left.mu, left.alpha, left.delta}, right)};
}

/// Coefficients of mu, alpha and delta.
Expressions coefficients(const char* text, const Expression& n) {
  return recorded_text(text,
                       {{"n", Shortened(n)}, {R"(\mu)", {1.0, 0.0, 0.0}}, {R"(\alpha)", {0.0, 1.0, 0.0}}});
}

/// The printed and the counted cost differ by at least `margin`.
Lemma differ(const Expression& counted, const Expression& printed, double margin) {
  return {.name = "printed_differs", .follows = {apart(counted, printed, margin)}, .tactic = by_arithmetic};
}

/// Count of multiplications for three unknowns.
template <class Run>
Expression multiplications(const Run& run) {
  Rows<Counted<double>> rows(3, std::vector<Counted<double>>(4, 1.0));
  return static_cast<double>(operations_of([&] { run(rows); }).multiplications);
}

}  // namespace

Provables proofs() {
  const Expression n = Expression::letter("n"), two = 2, three = 3;
  const auto difference = [](const Expression& of) { return printed_total(of) - printed_original(of); };
  const auto second = multiplications([](auto& rows) { full_step(rows, 1); });
  const auto full = multiplications([](auto& rows) {
    for (std::size_t k = 0; k < rows.size(); ++k) full_step(rows, k);
  });
  const auto forward = multiplications([](auto& rows) { solve_forward(rows, Clearing::crosswise); });
  const std::string counted = "counted for n = 3, the multiplications are not those printed";
  return {
      {"7.1-full_second_row", counted, {differ(second, printed_second_row(three).mu, 1)}, 1},
      {"7.1-full_cost", counted, {differ(full, printed_full(three).mu, 3)}, 3},
      {"7.1-full_total", counted, {differ(full, printed_total(three).mu, 3)}, 3},
      {"7.1-difference",
       "it is C' - C, both as printed, for all n",
       {equal_costs("printed", difference(n),
                    {printed_difference(n).mu, printed_difference(n).alpha, printed_difference(n).delta})}},
      {"7.1-factored",
       "C' - C is as corrected for all n, and for n = 2 its additions are not those printed",
       {equal_costs("corrected", difference(n), coefficients(factored_of_totals, n)),
        differ(difference(two).alpha, coefficients(printed_factored, two)[1], 0.6)},
       0.6},
      {"7.1-excess",
       "with the corrected C' it is as corrected for all n; " + counted,
       {equal_costs("corrected", corrected_total(n) - printed_original(n),
                    coefficients(factored_of_counts, n)),
        differ(full - forward, coefficients(printed_factored, three)[0], 3)},
       3}};
}

}  // namespace ex07_01

}  // namespace oddity
