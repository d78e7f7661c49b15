#pragma once

#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "chapters/formulas.hpp"

/// Tables of an exercise's claims: formulas, statements and numbers in the letters of samples (formulas.hpp).
///
/// chapters/README.md shows a claim.
namespace oddity {

// ---- formulas ---------------------------------------------------------------------------------------------

/// A claim about a formula: the same quantity by an independent route, the readings, and formulas that must
/// fail. If the right reading is a text alone, its single changes are near misses too.
template <class Sample>
struct FormulaClaim {
  std::string quantity = {};  ///< the compared quantity; empty: the claim's text
  Formula<Sample> truth;
  std::vector<Formula<Sample>> other_routes = {};  ///< further independent routes, checked for each reading
  Formula<Sample> printed;
  Formula<Sample> meant = {};
  Formula<Sample> corrected = {};
  InView<Sample> in_view = {};  ///< for an incomplete claim: the cases in which the printed formula holds
  std::vector<Formula<Sample>> near_misses = {};
  std::string changes_that_hold = {};  ///< why some single changes of a text hold as well
  Fault kind = Fault::none;
  std::string root = {};
  std::string why = {};
};

// ---- statements -------------------------------------------------------------------------------------------

/// A sentence, and whether a sample satisfies it. Without `holds` it is a relation, "$\ddot q<0$", in the
/// sample's letters on a page.
template <class Sample>
struct Statement {
  std::string text;
  std::function<bool(const Sample&)> holds = {};
};

/// The statement with its `holds`; by default this evaluates the relation.
template <class Sample>
Statement<Sample> computed(Statement<Sample> statement) {
  if (statement.holds || statement.text.empty()) return statement;
  if constexpr (Typeset<Sample>) {
    if (is_formula(statement.text))
      statement.holds = [text = statement.text, relation = TypesetRelation(statement.text.substr(
                                                    1, statement.text.size() - 2))](const Sample& s) {
        const auto so = relation(typeset_of(s));
        if (!so) throw std::logic_error(text + " is no relation of the sample's letters");
        return *so;
      };
  }
  if (!statement.holds) throw std::logic_error("nothing decides '" + statement.text + "'");
  return statement;
}

template <class Sample>
Check in_all(const std::string& text, const std::vector<Sample>& samples,
             const std::function<bool(const Sample&)>& holds) {
  long violations = 0;
  std::string where;
  for (const Sample& sample : samples) {
    if (holds(sample)) continue;
    if (++violations == 1) where = "one of them: " + where_of(sample);
  }
  return no_violations(text + ": cases against it", violations, static_cast<long>(samples.size()), where);
}

/// Compares the sentence, if it is an inequality or an equation, with `holds` over the samples.
template <class Sample>
Typesetting compare_typeset(const Statement<Sample>& statement, const std::vector<Sample>& samples) {
  if constexpr (Typeset<Sample>) {
    constexpr std::size_t enough = 64;
    std::vector<std::pair<TypesetLetters, bool>> said;
    for (std::size_t i = 0; i < std::min(enough, samples.size()); ++i)
      said.emplace_back(typeset_of(samples[i]), statement.holds(samples[i]));
    return compare_typeset(statement.text, said);
  }
  return {};
}

/// A claim that a statement is true in every case.
template <class Sample>
struct StatementClaim {
  Statement<Sample> printed;
  Statement<Sample> meant = {};
  Statement<Sample> corrected = {};
  InView<Sample> in_view = {};  ///< for an incomplete claim: the cases in which the printed statement holds
  std::vector<Statement<Sample>> near_misses = {};
  Fault kind = Fault::none;
  std::string root = {};
  std::string why = {};
};

// ---- numbers ----------------------------------------------------------------------------------------------

/// A claim about a number. The readings are the numbers as written, such as "0.800275" or "$-1.5$". Each may
/// be off by half a unit of its last decimal.
struct NumberClaim {
  std::string quantity = {};  ///< the compared quantity; empty: the claim's text
  Route truth;
  std::string printed;
  std::string meant = {};
  std::string corrected = {};
  std::vector<std::string> near_misses = {};
  Fault kind = Fault::none;
  std::string root = {};
  std::string why = {};
};

/// Compares a number as written with a route. Throws std::logic_error if `written` is not a number.
Check as_written(std::string quantity, const std::string& written, const Route& truth);
/// Compares a number whose digits are cut off, not rounded: by the middle of the interval they leave open.
Check as_cut_off(std::string quantity, const std::string& written, const Route& truth);

// ---- the table of claims ----------------------------------------------------------------------------------

/// "$a$" and "$b$" of $a=b$, "$(b,\ c)$" of $a=b=c$; words may follow it. Throws std::logic_error for a text
/// that does not begin with an equation.
std::pair<std::string, std::string> sides_of_equation(const std::string& text);

/// A table's formulas over some samples.
///
///     const auto claim = table.over(samples);
///     claim("speed", 12, "Its speed is $gt$", {"Newton's law", by_newton}, "$gt$");
///     claim.equation("way", 14, "$x=gt^2/2$", {"the integral of the speed", integral});
template <class Table, class Sample, class Stated, class Parts>
struct Over {
  Table& table;
  const std::vector<Sample>& samples;

  void operator()(std::string_view slug, int line, std::string says, const Parts& parts) const {
    table.formula(slug, line, std::move(says), samples, parts);
  }
  /// A claim that is right as printed. `quantity` is by default the text, and `changes_that_hold` the reason
  /// why some single changes of `printed` hold as well.
  void operator()(std::string_view slug, int line, std::string says, Stated truth, Stated printed,
                  std::string quantity = {}, std::string changes_that_hold = {}) const {
    Parts parts;
    parts.quantity = std::move(quantity), parts.changes_that_hold = std::move(changes_that_hold);
    parts.truth = std::move(truth), parts.printed = std::move(printed);
    (*this)(slug, line, std::move(says), parts);
  }
  /// The claim $a=b$, or $a=b=c$, which words may follow: that b, and c, is the truth of the quantity a.
  /// Throws std::logic_error if a is a formula of the letters with another value than the truth.
  void equation(std::string_view slug, int line, const std::string& text, Stated truth,
                std::string changes_that_hold = {}) const {
    const auto [quantity, printed] = sides_of_equation(text);
    require_truth_of(quantity, truth);
    (*this)(slug, line, text, std::move(truth), Stated{printed}, quantity, std::move(changes_that_hold));
  }
  /// Such a claim of which our copy has lost some typography, such as a fraction's bar, and the equation as
  /// meant.
  void lost(std::string_view slug, int line, const std::string& text, Stated truth, const std::string& meant,
            std::string why) const {
    Parts parts;
    const auto [quantity, printed] = sides_of_equation(text);
    require_truth_of(quantity, truth);
    parts.quantity = quantity, parts.truth = std::move(truth), parts.printed = Stated{printed};
    parts.meant = Stated{sides_of_equation(meant).second}, parts.why = std::move(why);
    (*this)(slug, line, text, parts);
  }

 private:
  void require_truth_of(const std::string& quantity, const Formula<Sample>& truth) const {
    if constexpr (Typeset<Sample>) {
      const std::string_view formula = std::string_view(quantity).substr(1, quantity.size() - 2);
      if (samples.empty() || !typeset_value(formula, typeset_of(samples[0]))) return;
      const Check check = compare(quantity, computed(Formula<Sample>{quantity}), computed(truth), samples);
      if (!check.holds())
        throw std::logic_error(quantity + " has another value than '" + truth.text + "', at " + check.where);
    }
  }
};

/// The claims of an exercise.
class Claims {
 public:
  /// `exercise`: "3.5".
  explicit Claims(std::string exercise) : exercise_(std::move(exercise)) {}

  template <class Sample>
  Claims& formula(std::string_view slug, int line, std::string says, const std::vector<Sample>& samples,
                  const FormulaClaim<Sample>& parts) {
    const std::string quantity = parts.quantity.empty() ? says : parts.quantity;
    Reading in_view;
    const LettersAtSamples<Sample>& letters = letters_of(samples);
    const AtSamples<Sample> truth = at_samples(parts.truth, letters);
    std::vector<AtSamples<Sample>> other_routes;
    for (const Formula<Sample>& route : parts.other_routes)
      other_routes.push_back(at_samples(route, letters));
    if (parts.in_view.is)
      if (const auto seen = parts.in_view.of(samples); !seen.empty())
        in_view = {parts.in_view.text,
                   {compare(quantity, computed(parts.printed), computed(parts.truth), seen)}};
    judged(slug, line, std::move(says), parts, in_view, [&](const Formula<Sample>& stated) -> Reading {
      const Formula<Sample> formula = computed(stated);
      if (!formula.of) return {};
      // A text alone is its own code, but an equation's sides may have values in the letters.
      const bool is_own = is_text(stated) && is_formula(stated.text) &&
                          formula::sides_of(stated.text.substr(1, stated.text.size() - 2)).relations.empty();
      const Typesetting typeset = is_own ? Typesetting{true, "", ""} : compare_typeset(formula, samples);
      const AtSamples<Sample> here = at_samples(stated, letters);
      Reading reading{formula.text, {compare(quantity, here, truth)}, typeset.read};
      for (const AtSamples<Sample>& route : other_routes)
        reading.checks.push_back(compare(quantity, here, route));
      for (const std::string& seen : {typeset.difference, reading.holds() ? typeset.unequal : ""})
        if (!seen.empty()) differences_.push_back(std::string(slug) + ": " + seen);
      return reading;
    });
    const Formula<Sample>& right = !parts.meant.text.empty()       ? parts.meant
                                   : !parts.corrected.text.empty() ? parts.corrected
                                                                   : parts.printed;
    if (is_text(right))
      for (Reading& one : single_changes(quantity, right, truth, letters, parts.changes_that_hold))
        claims_.back().near_misses.push_back(std::move(one));
    return *this;
  }

  template <class Sample>
  Claims& statement(std::string_view slug, int line, std::string says, const std::vector<Sample>& samples,
                    const StatementClaim<Sample>& parts) {
    Reading in_view;
    if (parts.in_view.is)
      if (const auto seen = parts.in_view.of(samples); !seen.empty())
        in_view = {parts.in_view.text, {in_all(parts.printed.text, seen, computed(parts.printed).holds)}};
    return judged(slug, line, std::move(says), parts, in_view,
                  [&](const Statement<Sample>& stated) -> Reading {
                    const Statement<Sample> statement = computed(stated);
                    if (!statement.holds) return {};
                    const Typesetting typeset = compare_typeset(statement, samples);
                    if (!typeset.difference.empty())
                      differences_.push_back(std::string(slug) + ": " + typeset.difference);
                    return {statement.text, {in_all(statement.text, samples, statement.holds)}, typeset.read};
                  });
  }

  template <class Sample>
  auto over(const std::vector<Sample>& samples) {
    return Over<Claims, Sample, Formula<Sample>, FormulaClaim<Sample>>{*this, samples};
  }

  Claims& number(std::string_view slug, int line, std::string says, const NumberClaim& parts);

  /// Any other claim: readings with their own checks. The table sets its id and its exercise.
  /// By default the fault of a claim with `meant` is its lost typography. With `corrected` it is an
  /// omission if there is an `in_view`, or else the formula.
  Claims& add(std::string_view slug, int line, std::string says, Claim parts);

  /// All claims, ordered by line. Throws std::logic_error if a typeset formula differs from the computed one.
  std::vector<Claim> in_order() const;

 private:
  template <class Parts, class Read>
  Claims& judged(std::string_view slug, int line, std::string says, const Parts& parts, Reading in_view,
                 const Read& read) {
    Claim claim{.printed = read(parts.printed),
                .meant = read(parts.meant),
                .corrected = read(parts.corrected),
                .in_view = std::move(in_view),
                .why = parts.why,
                .kind = parts.kind,
                .root = parts.root};
    for (const auto& near : parts.near_misses) claim.near_misses.push_back(read(near));
    return add(slug, line, std::move(says), std::move(claim));
  }

  template <class Sample>
  const LettersAtSamples<Sample>& letters_of(const std::vector<Sample>& samples) {
    std::shared_ptr<void>& kept = letters_[{&samples, &type_of<Sample>}];
    auto known = std::static_pointer_cast<const LettersAtSamples<Sample>>(kept);
    if (known && known->are_of(samples)) return *known;
    kept = std::make_shared<LettersAtSamples<Sample>>(samples);
    return *std::static_pointer_cast<const LettersAtSamples<Sample>>(kept);
  }

  std::string exercise_;
  std::vector<Claim> claims_;
  std::vector<std::string> differences_;
  template <class Sample>
  static constexpr char type_of = 0;  ///< its address names the type
  std::map<std::pair<const void*, const void*>, std::shared_ptr<void>> letters_;
};

}  // namespace oddity
