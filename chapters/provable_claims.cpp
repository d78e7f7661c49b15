#include "chapters/provable_claims.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "chapters/integral_proofs.hpp"
#include "chapters/particle_sums.hpp"
#include "formula/evaluate.hpp"

namespace oddity {

namespace formula {

template <>
struct Constants<Shortened> {
  static Shortened pi() { return pi_in_coq(); }
};

}  // namespace formula

// Functions used in texts. Half of a whole number as an exponent is a power of the root.
Shortened log(const Shortened& x) { return log(x.expression()); }
Shortened tan(const Shortened& x) { return function("tan", x.expression()); }
Shortened asin(const Shortened& x) { return function("asin", x.expression()); }
Shortened acos(const Shortened& x) { return function("acos", x.expression()); }
Shortened atan(const Shortened& x) { return atan(x.expression()); }
Shortened pow(const Shortened& x, const Shortened& exponent) {
  std::string_view text = exponent.expression().coq();
  const bool below = text.starts_with("- (");
  if (below) text = text.substr(3, text.size() - 4);
  int halves = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), halves);
  if (error != std::errc{} || text.substr(static_cast<std::size_t>(end - text.data())) != " / 2")
    return exp(exponent * log(x));
  const Shortened power = pow(sqrt(x), halves);
  return below ? 1.0 / power : power;
}

namespace {

/// The formula with a letter in place of each sum.
formula::Tree with_totals(formula::Tree x, std::vector<formula::Matrix<Shortened>>& values,
                          const std::string& particle) {
  if (x.kind() == formula::Kind::sum_over) {
    formula::Matrix<Shortened> total = formula::evaluate(x, values);
    for (Shortened& one : total.entries)
      one = Shortened::letter("(total l (fun " + particle + " => " + one.expression().coq() + "))");
    values.push_back(std::move(total));
    return formula::Tree({.kind = formula::Kind::letter,
                          .entries = {{.indices = {}, .rates = {static_cast<int>(values.size()) - 1}}}});
  }
  for (std::size_t i = 0; i < x->children.size(); ++i)
    x = x.with_child(i, with_totals(x.child(i), values, particle));
  return x;
}

}  // namespace

Expressions recorded_sums(const std::string& text, const TypesetIn<Shortened>& letters,
                          const std::string& particle) {
  formula::Names names;
  std::vector<formula::Matrix<Shortened>> values;
  for (const auto& [name, value] : letters) {
    names.push_back(name);
    values.push_back(formula::of_letter(value.all));
  }
  std::vector<formula::Tree> sides = TypesetFormula(text).sides(names);
  if (!particle.empty())
    for (formula::Tree& side : sides) side = with_totals(side, values, particle);
  formula::Matrix<Shortened> all = formula::evaluate(sides.at(0), values);
  if (sides.size() > 1 && !formula::is_number(sides[1], "0"))
    all = formula::added(std::move(all), formula::evaluate(sides[1], values), true);
  Expressions recorded;
  for (const Shortened& one : all.entries) recorded.push_back(one.expression());
  return recorded;
}

Expressions recorded_text(const std::string& text, const TypesetIn<Shortened>& letters) {
  return recorded_sums(text, letters, "");
}

std::string quantified(const std::vector<std::string>& names) {
  std::string all = "(";
  for (const std::string& name : names) all += name + " ";
  return all + ": R)";
}

void in_a_row(Expressions& a, Expressions& b) {
  Expressions& lone = a.size() == 1 ? a : b;
  const std::size_t n = std::max(a.size(), b.size());
  if (lone.size() == 1 && n > 1) lone = Expressions(n, lone[0]);
}

Lemma off_at(const Expressions& printed, const Expressions& truth, const Value& difference, double& margin) {
  std::size_t largest = 0;
  for (std::size_t i = 0; i < difference.size(); ++i)
    if (std::abs(difference[i]) > std::abs(difference[largest])) largest = i;
  const double size = 0.99 * std::abs(difference[largest]);
  const double digit = std::pow(10, 1 - std::floor(std::log10(size)));
  margin = std::floor(size * digit) / digit;
  return {.name = "printed_differs",
          .follows = {apart(printed.at(largest), truth.at(largest), margin)},
          .tactic = "interval"};
}

bool RecordedClaim::is_itself() const {
  return std::ranges::equal(right, truth, {}, &Expression::coq, &Expression::coq);
}

Provable provable(RecordedClaim claim, const SaidOfAll& all) {
  in_a_row(claim.right, claim.truth);
  Lemma equation{claim.reading.empty() ? "printed" : claim.reading, all.letters, all.given,
                 equal(claim.right, claim.truth), all.tactic};
  if (claim.reading.empty())
    return {.claim = claim.id, .says = all.says, .lemmas = {std::move(equation)}, .preamble = all.preamble};
  in_a_row(claim.printed_value, claim.truth_value);
  Value difference = claim.printed_value;
  for (std::size_t k = 0; k < difference.size(); ++k) difference[k] -= claim.truth_value[k];
  in_a_row(claim.printed_there, claim.truth_there);
  double margin = 0;
  Lemma off = off_at(claim.printed_there, claim.truth_there, difference, margin);
  off.tactic = all.bounds;
  return {.claim = claim.id,
          .says = "as " + claim.reading + " " + all.says + "; as printed it is off at an example",
          .lemmas = {std::move(equation), std::move(off)},
          .margin = margin,
          .preamble = all.preamble};
}

std::string by_angles(const std::vector<std::string>& angles, const std::string& field) {
  std::string tactic, known;
  for (const std::string& angle : angles) {
    tactic += "\n  assert (circle_" + angle + " : sin (" + angle + ") * sin (" + angle + ") = 1 - cos (" +
              angle + ") * cos (" + angle + ")) by (pose proof (sin2_cos2 (" + angle +
              ")) as all; unfold Rsqr in all; lra);";
    known += " circle_" + angle;
  }
  return tactic + "\n  " + field + (known.empty() ? "" : " [" + known.substr(1) + "]");
}

}  // namespace oddity
