#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "chapters/claims.hpp"
#include "chapters/letters.hpp"
#include "chapters/provable.hpp"

/// Claims whose formulas are generic in their number type. Each formula is stated once, computed over samples
/// of doubles, and proved for all values of the letters. A sample is `template <class T> struct Of` with one
/// of four functions. table() returns its Letters<T>, letters() an array of T*. quantities() is the same
/// where the sizes of terms cannot be found from them. recorded() returns its numbers as Of<Shortened>.
namespace oddity {

template <class... Numbers>
requires(std::same_as<Numbers, Shortened> || ...) std::vector<Shortened> values(Numbers... x) {
  return {Shortened(x)...};
}

namespace detail {

template <class X>
Expressions recorded_value(const X& x) {
  if constexpr (std::convertible_to<X, Shortened>) {
    return {Shortened(x).expression()};
  } else {
    Expressions all;
    for (const auto& component : x) all.push_back(Shortened(component).expression());
    return all;
  }
}

/// Its letters, or its quantities().
template <class Sample>
auto letters_or_quantities(Sample& sample) {
  if constexpr (Lettered<Sample>)
    return oddity::letters_of(sample);
  else
    return sample.quantities();
}

}  // namespace detail

/// The value of a formula or an equation that is stated as text alone.
Expressions recorded_text(const std::string& text, const TypesetIn<Shortened>& letters);

/// A formula that is also recorded for Coq if it accepts a sample of expressions, or is a text in the letters
/// of such a sample.
template <template <class> class Of>
struct ProvableFormula : Formula<Of<double>> {
  std::function<Expressions(const Of<Shortened>&)> recorded;

  ProvableFormula() = default;
  ProvableFormula(const char* written) : ProvableFormula(std::string(written)) {}
  ProvableFormula(std::string written) : Formula<Of<double>>{std::move(written), {}} {
    if constexpr (requires(const Of<Shortened>& s) {
                    { typeset_of(s) } -> std::same_as<TypesetIn<Shortened>>;
                  })
      recorded = [text = this->text](const Of<Shortened>& s) { return recorded_text(text, typeset_of(s)); };
  }
  template <class F>
  ProvableFormula(std::string written, const F& f, std::function<double(const Of<double>&)> size = {})
      : Formula<Of<double>>{std::move(written), f, std::move(size)} {
    if constexpr (std::invocable<const F&, const Of<Shortened>&>)
      recorded = [f](const Of<Shortened>& s) { return detail::recorded_value(f(s)); };
  }
};

template <template <class> class Of>
struct ProvableClaim {
  std::string quantity = {};
  ProvableFormula<Of> truth;
  std::vector<Formula<Of<double>>> other_routes = {};
  ProvableFormula<Of> printed;
  ProvableFormula<Of> meant = {};
  ProvableFormula<Of> corrected = {};
  InView<Of<double>> in_view = {};
  std::vector<ProvableFormula<Of>> near_misses = {};
  std::string changes_that_hold = {};
  Fault kind = Fault::none;
  std::string root = {};
  std::string why = {};
};

/// Common data of the proofs of an exercise's formulas.
template <template <class> class Of>
struct ForAll {
  Of<Shortened> any;
  std::string letters;                    ///< "(x y : R)"
  std::vector<Proposition> given = {};    ///< assumptions about the letters
  std::string tactic;                     ///< proves the right formulas
  std::string says;                       ///< "it holds for any ..."
  Of<double> example{};                   ///< where printed formulas are wrong
  std::vector<std::string> without = {};  ///< claims left out
  std::string preamble = {};
  std::string bounds = "interval";  ///< proves that a printed formula is off at the example
};

/// The sample with these letters, in their order.
template <template <class> class Of>
Of<Shortened> lettered(const std::vector<std::string>& names) {
  Of<Shortened> any{};
  std::size_t i = 0;
  for (Shortened* letter : detail::letters_or_quantities(any)) *letter = Shortened::letter(names.at(i++));
  return any;
}
std::string quantified(const std::vector<std::string>& names);
/// Common data of proofs in these letters, by default those of the sample's table(), and an example with
/// these values of the letters.
template <template <class> class Of>
ForAll<Of> for_all(const std::vector<std::string>& names, std::string tactic, std::string says,
                   const std::vector<double>& example = {}) {
  ForAll<Of> all{.any = lettered<Of>(names),
                 .letters = quantified(names),
                 .tactic = std::move(tactic),
                 .says = std::move(says)};
  const auto letters = detail::letters_or_quantities(all.example);
  for (std::size_t i = 0; i < example.size(); ++i) *letters[i] = example[i];
  return all;
}
template <template <class> class Of>
ForAll<Of> for_all(std::string tactic, std::string says, const std::vector<double>& example = {}) {
  return for_all<Of>(names_in_coq<Of<Shortened>>(), std::move(tactic), std::move(says), example);
}

/// A single number next to several is repeated, as those are forms of one quantity in a row.
void in_a_row(Expressions& a, Expressions& b);

/// The difference's largest component at an example, to prove that the two differ.
Lemma off_at(const Expressions& printed, const Expressions& truth, const Value& difference, double& margin);

/// Tactic: a sum of products of positive factors is not zero.
inline constexpr const char* by_positive_terms =
    "try (apply Rgt_not_eq; ring_simplify; "
    "repeat apply Rplus_lt_0_compat; repeat apply Rmult_lt_0_compat; try apply pow_lt; lra)";

/// Tactic: replaces the squares of these angles' sines by cosines, then solves by `field` or `ring`.
std::string by_angles(const std::vector<std::string>& angles, const std::string& field = "field");

template <template <class> class Of>
class ProvableClaims {
 public:
  using Samples = std::vector<Of<double>>;

  explicit ProvableClaims(Claims& claims) : claims_(claims) {}

  void formula(std::string_view slug, int line, std::string says, const Samples& samples,
               const ProvableClaim<Of>& c) {
    std::vector<Formula<Of<double>>> near(c.near_misses.begin(), c.near_misses.end());
    claims_.formula<Of<double>>(slug, line, std::move(says), samples,
                                {.quantity = c.quantity,
                                 .truth = c.truth,
                                 .other_routes = c.other_routes,
                                 .printed = c.printed,
                                 .meant = c.meant,
                                 .corrected = c.corrected,
                                 .in_view = c.in_view,
                                 .near_misses = std::move(near),
                                 .changes_that_hold = c.changes_that_hold,
                                 .kind = c.kind,
                                 .root = c.root,
                                 .why = c.why});
    stated_.emplace_back(slug, c);
  }
  auto over(const Samples& samples) {
    return Over<ProvableClaims, Of<double>, ProvableFormula<Of>, ProvableClaim<Of>>{*this, samples};
  }

  /// Proofs of all recorded claims that are not trivially x = x. `exercise`: "3.5".
  Provables proofs(const std::string& exercise, const ForAll<Of>& all) const {
    Provables proved;
    for (const auto& [slug, claim] : stated_)
      if (const std::string id = exercise + "-" + slug;
          provable(claim) && !among(all.without, slug) && !is_itself(claim, all))
        proved.push_back(!claim.meant.text.empty() || !claim.corrected.text.empty()
                             ? of_wrong(id, claim, all)
                             : of_right(id, claim, all));
    for (Provable& one : proved) one.preamble = all.preamble;
    return proved;
  }

 private:
  static bool among(const std::vector<std::string>& slugs, const std::string& slug) {
    return std::ranges::find(slugs, slug) != slugs.end();
  }
  static const ProvableFormula<Of>& right(const ProvableClaim<Of>& c) {
    return !c.meant.text.empty() ? c.meant : !c.corrected.text.empty() ? c.corrected : c.printed;
  }
  static bool provable(const ProvableClaim<Of>& c) {
    return c.truth.recorded && c.printed.recorded && right(c).recorded;
  }
  static bool is_itself(const ProvableClaim<Of>& c, const ForAll<Of>& all) {
    return std::ranges::equal(right(c).recorded(all.any), c.truth.recorded(all.any), {}, &Expression::coq,
                              &Expression::coq);
  }
  static Lemma equation(std::string name, const ProvableClaim<Of>& c, const ForAll<Of>& all) {
    Expressions stated = right(c).recorded(all.any), truth = c.truth.recorded(all.any);
    in_a_row(stated, truth);
    return {std::move(name), all.letters, all.given, equal(stated, truth), all.tactic};
  }
  static Provable of_right(const std::string& id, const ProvableClaim<Of>& c, const ForAll<Of>& all) {
    return {id, all.says, {equation("printed", c, all)}};
  }
  static Of<Shortened> in_expressions(Of<double> example) {
    if constexpr (requires { example.recorded(); }) {
      return example.recorded();
    } else {
      Of<Shortened> recorded{};
      auto numbers = detail::letters_or_quantities(example);
      std::size_t i = 0;
      for (Shortened* letter : detail::letters_or_quantities(recorded)) *letter = *numbers[i++];
      return recorded;
    }
  }
  static Provable of_wrong(const std::string& id, const ProvableClaim<Of>& c, const ForAll<Of>& all) {
    const Of<double>& example = all.example;
    const Of<Shortened> recorded = in_expressions(example);
    const auto value = [&](const Formula<Of<double>>& formula) { return computed(formula).of(example); };
    Value difference = value(c.printed), truth = value(c.truth);
    in_a_row(difference, truth);
    for (std::size_t k = 0; k < difference.size(); ++k) difference[k] -= truth[k];
    Expressions stated = c.printed.recorded(recorded), is = c.truth.recorded(recorded);
    in_a_row(stated, is);
    double margin = 0;
    Lemma off = off_at(stated, is, difference, margin);
    off.tactic = all.bounds;
    const std::string reading = !c.meant.text.empty() ? "meant" : "corrected";
    return {id,
            "as " + reading + " " + all.says + "; as printed it is off at an example",
            {equation(reading, c, all), std::move(off)},
            margin};
  }

  Claims& claims_;
  std::vector<std::pair<std::string, ProvableClaim<Of>>> stated_;
};

}  // namespace oddity
