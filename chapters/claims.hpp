#pragma once

#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
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

/// A statement about samples of any type.
struct AnyStatement {
  std::string text;
  std::function<bool(std::size_t)> holds = {};
};
/// Refers to the statement and the samples.
template <class Sample>
AnyStatement any_statement(const Statement<Sample>& statement, const std::vector<Sample>& samples) {
  AnyStatement any{statement.text};
  if (statement.holds) any.holds = [&](std::size_t i) { return statement.holds(samples[i]); };
  return any;
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

// ---- of samples of any type -------------------------------------------------------------------------------

struct AnyFormulaClaim {
  std::string quantity;
  AnyFormula truth;
  std::vector<AnyFormula> other_routes = {};
  AnyFormula printed, meant, corrected;
  AnyInView in_view;
  std::vector<AnyFormula> near_misses = {};
  std::string changes_that_hold;
  Fault kind;
  std::string root, why;
};

struct AnyStatementClaim {
  AnyStatement printed, meant, corrected;
  AnyInView in_view;
  std::vector<AnyStatement> near_misses = {};
  Fault kind;
  std::string root, why;
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
      const Check check = compare<Sample>(quantity, {quantity}, truth, samples);
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

  /// `parts`: a FormulaClaim, or one with the same members.
  template <class Sample, class Parts = FormulaClaim<Sample>>
  Claims& formula(std::string_view slug, int line, std::string says, const std::vector<Sample>& samples,
                  const Parts& parts) {
    const auto any = [&](const Formula<Sample>& formula) { return any_formula(formula, samples); };
    AnyFormulaClaim claim{.quantity = parts.quantity,
                          .truth = any(parts.truth),
                          .printed = any(parts.printed),
                          .meant = any(parts.meant),
                          .corrected = any(parts.corrected),
                          .in_view = any_in_view(parts.in_view, samples),
                          .changes_that_hold = parts.changes_that_hold,
                          .kind = parts.kind,
                          .root = parts.root,
                          .why = parts.why};
    for (const auto& route : parts.other_routes) claim.other_routes.push_back(any(route));
    for (const auto& near : parts.near_misses) claim.near_misses.push_back(any(near));
    return formula(slug, line, std::move(says), any_samples(samples), claim);
  }
  Claims& formula(std::string_view slug, int line, std::string says, std::unique_ptr<const AnySamples>,
                  const AnyFormulaClaim&);

  template <class Sample>
  Claims& statement(std::string_view slug, int line, std::string says, const std::vector<Sample>& samples,
                    const StatementClaim<Sample>& parts) {
    const auto any = [&](const Statement<Sample>& statement) { return any_statement(statement, samples); };
    AnyStatementClaim claim{.printed = any(parts.printed),
                            .meant = any(parts.meant),
                            .corrected = any(parts.corrected),
                            .in_view = any_in_view(parts.in_view, samples),
                            .kind = parts.kind,
                            .root = parts.root,
                            .why = parts.why};
    for (const auto& near : parts.near_misses) claim.near_misses.push_back(any(near));
    return statement(slug, line, std::move(says), SamplesOf<Sample>(samples), claim);
  }
  Claims& statement(std::string_view slug, int line, std::string says, const AnySamples&,
                    const AnyStatementClaim&);

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
  template <class Sample>
  static std::unique_ptr<const AnySamples> any_samples(const std::vector<Sample>& samples) {
    return std::unique_ptr<const AnySamples>(new SamplesOf<Sample>(samples));
  }
  template <class Parts, class Read>
  Claims& judged(std::string_view slug, int line, std::string says, const Parts&, Reading in_view,
                 const Read&);
  const LettersAtSamples& letters_of(std::unique_ptr<const AnySamples>);

  std::string exercise_;
  std::vector<Claim> claims_;
  std::vector<std::string> differences_;
  std::map<std::pair<const void*, const void*>, std::unique_ptr<const LettersAtSamples>> letters_;
};

}  // namespace oddity
