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

/// Code as a function of a sample. Without captured values it is a pointer, whose wrapper all such code
/// shares.
template <class F, class Sample>
struct CodeWithoutValues {
  static Value value(const Sample& s) { return F{}(s); }
  static Expressions recorded(const Sample& s) { return recorded_value(F{}(s)); }
};
template <class F>
concept WithoutValues = std::is_empty_v<F> && std::is_default_constructible_v<F>;
template <class Sample, class F>
std::function<Value(const Sample&)> valued(const F& f) {
  if constexpr (WithoutValues<F>)
    return &CodeWithoutValues<F, Sample>::value;
  else
    return f;
}
template <class Sample, class F>
std::function<Expressions(const Sample&)> recording(const F& f) {
  if constexpr (WithoutValues<F>)
    return &CodeWithoutValues<F, Sample>::recorded;
  else
    return [f](const Sample& s) { return recorded_value(f(s)); };
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
      : Formula<Of<double>>{std::move(written), detail::valued<Of<double>>(f), std::move(size)} {
    if constexpr (std::invocable<const F&, const Of<Shortened>&>)
      recorded = detail::recording<Of<Shortened>>(f);
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

/// A claim with its formulas as expressions, in the letters, and at an example if it is not right as printed.
struct RecordedClaim {
  std::string id;
  std::string reading;  ///< "meant" or "corrected"; empty if it is right as printed
  Expressions right, truth;
  Expressions printed_there = {}, truth_there = {};
  Value printed_value = {}, truth_value = {};

  bool is_itself() const;
};
/// Data of ForAll that do not depend on the sample.
struct SaidOfAll {
  const std::string& letters;
  const std::vector<Proposition>& given;
  const std::string &tactic, &says, &preamble, &bounds;
};
Provable provable(RecordedClaim, const SaidOfAll&);

template <template <class> class Of>
class ProvableClaims {
 public:
  using Samples = std::vector<Of<double>>;

  explicit ProvableClaims(Claims& claims) : claims_(claims) {}

  void formula(std::string_view slug, int line, std::string says, const Samples& samples,
               const ProvableClaim<Of>& c) {
    claims_.formula(slug, line, std::move(says), samples, c);
    const bool is_meant = !c.meant.text.empty(), is_wrong = is_meant || !c.corrected.text.empty();
    stated_.push_back({std::string(slug),
                       is_meant   ? "meant"
                       : is_wrong ? "corrected"
                                  : "",
                       c.truth, c.printed,
                       is_meant   ? c.meant
                       : is_wrong ? c.corrected
                                  : c.printed});
  }
  auto over(const Samples& samples) {
    return Over<ProvableClaims, Of<double>, ProvableFormula<Of>, ProvableClaim<Of>>{*this, samples};
  }

  /// Proofs of all recorded claims that are not trivially x = x. `exercise`: "3.5".
  Provables proofs(const std::string& exercise, const ForAll<Of>& all) const {
    const SaidOfAll said{all.letters, all.given, all.tactic, all.says, all.preamble, all.bounds};
    Provables proved;
    for (const Stated& c : stated_) {
      if (!c.truth.recorded || !c.printed.recorded || !c.right.recorded ||
          std::ranges::find(all.without, c.slug) != all.without.end())
        continue;
      RecordedClaim recorded{exercise + "-" + c.slug, c.reading, c.right.recorded(all.any),
                             c.truth.recorded(all.any)};
      if (recorded.is_itself()) continue;
      if (!c.reading.empty()) {
        const Of<Shortened> example = in_expressions(all.example);
        recorded.printed_there = c.printed.recorded(example);
        recorded.truth_there = c.truth.recorded(example);
        recorded.printed_value = value_at(c.printed, all.example);
        recorded.truth_value = value_at(c.truth, all.example);
      }
      proved.push_back(provable(std::move(recorded), said));
    }
    return proved;
  }

 private:
  struct Stated {
    std::string slug, reading;
    ProvableFormula<Of> truth, printed, right;
  };
  static Value value_at(const Formula<Of<double>>& formula, const Of<double>& example) {
    if (formula.of) return formula.of(example);
    if constexpr (Typeset<Of<double>>) return TypesetFormula(formula.text)(typeset_of(example));
    throw std::logic_error("'" + formula.text + "' is not computed, and its samples have no typeset letters");
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

  Claims& claims_;
  std::vector<Stated> stated_;
};

}  // namespace oddity
