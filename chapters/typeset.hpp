#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "chapters/exercise.hpp"
#include "formula/matrix.hpp"
#include "formula/parse.hpp"

/// Formulas as a page has them, computed: so that what is typeset beside a function is what that computes.
namespace oddity {

/// The letters of a sample as they are typeset, with what they are there: {R"(\dot\theta)", 0.3},
/// {R"(\mathbf r)", {1, 2, 0}}, {"dV/dr", 2}, {"m_{12}", 3}. The longest that fits is taken. Four or nine
/// numbers are a square matrix, by rows.
using TypesetLetters = std::vector<std::pair<std::string, Value>>;

/// The first of these letters, "$m_2$ = 1.25, $g$ = 9.81", with all digits.
std::string told(const TypesetLetters&, std::size_t count);

/// The letters' names and values, as formula/ takes them.
formula::Names names_of(const TypesetLetters&);
std::vector<formula::Matrix<double>> values_of(const TypesetLetters&);

/// Value of a formula of TeX, by the grammar of formula/parse.hpp: m_2g-c_1(S_1-L_1). Nothing where it is not
/// one of these letters, or has no value.
std::optional<Value> typeset_value(std::string_view formula, const TypesetLetters&);
/// Reads once what is evaluated often: the tree, and its value.
std::optional<formula::Tree> typeset_tree(std::string_view formula, const formula::Names&);
std::optional<Value> typeset_value(const formula::Tree&, const std::vector<formula::Matrix<double>>& letters);

/// A reading that is stated as text alone. It is one formula, or an equation: then its value is what the left
/// side is more than the right one, or the right side, where the left one is nothing or only what that is
/// called: v, W(T). Of 0=x it is x.
class TypesetFormula {
 public:
  /// Reads at the first value.
  explicit TypesetFormula(std::string text) : text_(std::move(text)) {}

  const std::string& text() const { return text_; }
  /// Throws std::logic_error where the text is no formula of these letters, or has no value.
  Value operator()(const TypesetLetters&) const;
  /// Of an equation, the size of the terms of both sides, which cancel; of a formula, zero.
  double cancelling(const TypesetLetters&) const;

  /// The sides that count, in these letters: one or two.
  std::vector<formula::Tree> sides(const formula::Names&) const;
  using Values = std::vector<formula::Matrix<double>>;
  static Value value(const std::vector<formula::Tree>& sides, const Values& letters);
  static double cancelling(const std::vector<formula::Tree>& sides, const Values& letters);

 private:
  struct Read {
    formula::Names names;
    std::vector<formula::Tree> sides;
    std::vector<bool> used;  ///< of the letters
  };
  const Read& read(const TypesetLetters&) const;
  std::string text_;
  mutable std::shared_ptr<const Read> read_ = nullptr;
};

/// Whether it is so, \ddot q<0 or x_1=x_2=0, and for tuples in every component; equal is to a billionth of
/// the terms that are added up. Nothing where a side is none that is known, or there is but one.
std::optional<bool> typeset_relation(std::string_view formula, const TypesetLetters&);

/// Forms of one quantity in a row: a lone number beside several is each of them.
void in_a_row(Value& a, Value& b);

using formula::is_formula;

/// A text beside what is computed under it.
struct Typesetting {
  bool read = false;            ///< it is a formula of the letters that are known, and what is computed
  std::string difference = {};  ///< what it is instead
  /// Where it is one side of an equation that is computed: what another side is instead. An equation that is
  /// not true has this too.
  std::string unequal = {};
};

/// A text, some samples' letters, and what is computed at each. An equation may stand for one of its sides,
/// but not for the lone letter on its left, for several of them in a row, or for what two differ by.
Typesetting compare_typeset(const std::string& text,
                            const std::vector<std::pair<TypesetLetters, Value>>& computed);

/// A text, some samples' letters, and whether it is said to be so of each.
Typesetting compare_typeset(const std::string& text,
                            const std::vector<std::pair<TypesetLetters, bool>>& said);

/// Whether it has been read. Throws std::logic_error where it is something else.
bool is_as_typeset(const Typesetting&);

}  // namespace oddity
