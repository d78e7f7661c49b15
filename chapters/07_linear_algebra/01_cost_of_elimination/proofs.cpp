#include "chapters/proofs.hpp"

#include "chapters/07_linear_algebra/01_cost_of_elimination/cost_formulas.hpp"
#include "chapters/07_linear_algebra/01_cost_of_elimination/cost_of_elimination.hpp"
#include "solvers/counted.hpp"

namespace oddity::ex07_01 {

namespace {

using Recorded = CostOf<Expression>;

/// All three counts at once: what the operations cost at any prices.
Expression at_any_prices(const Recorded& cost) {
  return cost.mu * Expression::letter("mu") + cost.alpha * Expression::letter("alpha") +
         cost.delta * Expression::letter("delta");
}

/// For all n and all prices.
Proof identity(const std::string& claim, const std::string& reading, const std::string& says,
               const Recorded& left, const Recorded& right) {
  return {claim,
          reading,
          Proof::Kind::identity,
          says,
          {"n", "mu", "alpha", "delta"},
          at_any_prices(left),
          at_any_prices(right)};
}

/// Printed and counted differ by this margin, or more.
Proof refuted(const std::string& claim, const std::string& says, const Expression& counted,
              const Expression& printed, const std::string& margin) {
  return {claim, "printed", Proof::Kind::far, says, {}, counted, printed, margin};
}

/// Multiplications, counted, for three unknowns.
template <class Run>
Expression multiplications(const Run& run) {
  Rows<Counted<double>> rows(3, std::vector<Counted<double>>(4, 1.0));
  return operations_of([&] { run(rows); }).multiplications;
}

}  // namespace

std::vector<Proof> proofs() {
  const Expression n = Expression::letter("n"), two = 2, three = 3;
  const auto difference = [](const Expression& of) { return printed_total(of) - printed_original(of); };
  const auto second = multiplications([](auto& rows) { full_step(rows, 1); });
  const auto full = multiplications([](auto& rows) {
    for (std::size_t k = 0; k < rows.size(); ++k) full_step(rows, k);
  });
  const auto forward = multiplications([](auto& rows) { solve_forward(rows, Clearing::crosswise); });
  const std::string says = "multiplications counted for n = 3, and as printed";
  return {refuted("7.1-full_second_row", says, second, printed_second_row(three).mu, "1"),
          refuted("7.1-full_cost", says, full, printed_full(three).mu, "3"),
          refuted("7.1-full_total", says, full, printed_total(three).mu, "3"),
          identity("7.1-difference", "printed", "C' - C, both as printed, for all n and all prices",
                   difference(n), printed_difference(n)),
          identity("7.1-factored", "corrected", "6 (C' - C), both as printed, for all n and all prices",
                   6 * difference(n), six_times_bracket(n, rest_of_totals<Expression>())),
          refuted("7.1-factored", "additions of 6 (C' - C) for n = 2, and as factored in print",
                  6 * difference(two).alpha, six_times_bracket(two, printed_rest<Expression>()).alpha, "4"),
          identity("7.1-excess", "corrected", "6 (C' - C) with C' as corrected, for all n and all prices",
                   6 * (corrected_total(n) - printed_original(n)),
                   six_times_bracket(n, rest_of_counts<Expression>())),
          refuted("7.1-excess", "six times the " + says, 6 * (full - forward),
                  six_times_bracket(three, printed_rest<Expression>()).mu, "18")};
}

}  // namespace oddity::ex07_01
