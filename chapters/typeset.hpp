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

/// Evaluates formulas as a page shows them, so that they can be compared with the function next to them.
namespace oddity {

/// The letters of a sample as they are typeset, with their values: {R"(\dot\theta)", 0.3}, {R"(\mathbf r)",
/// {1, 2, 0}}, {"dV/dr", 2}, {"m_{12}", 3}. The longest letter that fits is taken. Four or nine numbers are a
/// square matrix, by rows.
using TypesetLetters = std::vector<std::pair<std::string, Value>>;

/// The first `count` letters, "$m_2$ = 1.25, $g$ = 9.81", with all digits.
std::string listed(const TypesetLetters&, std::size_t count);

/// The letters' names and values in the types of formula/.
formula::Names names_of(const TypesetLetters&);
std::vector<formula::Matrix<double>> values_of(const TypesetLetters&);

/// Value of a TeX formula, by the grammar of formula/parse.hpp: m_2g-c_1(S_1-L_1). Nullopt if it is not a
/// formula of these letters, or has no value.
std::optional<Value> typeset_value(std::string_view formula, const TypesetLetters&);
/// Parsed tree, to evaluate a formula many times, and its value.
std::optional<formula::Tree> typeset_tree(std::string_view formula, const formula::Names&);
std::optional<Value> typeset_value(const formula::Tree&, const std::vector<formula::Matrix<double>>& letters);

/// A reading that is stated as text alone: a formula or an equation. The value of an equation is the left
/// side minus the right one. If the left side is empty or only a name, v or W(T), it is the right side. For
/// 0=x it is x.
class TypesetFormula {
 public:
  /// Parses at the first evaluation.
  explicit TypesetFormula(std::string text) : text_(std::move(text)) {}

  const std::string& text() const { return text_; }
  /// Throws std::logic_error if the text is not a formula of these letters, or has no value.
  Value operator()(const TypesetLetters&) const;
  /// For an equation, the size of the terms of both sides, which cancel; for a formula, zero.
  double cancelling(const TypesetLetters&) const;

  /// The sides that determine the value, in these letters: one or two.
  std::vector<formula::Tree> sides(const formula::Names&) const;
  using Values = std::vector<formula::Matrix<double>>;
  static Value value(const std::vector<formula::Tree>& sides, const Values& letters);
  static double cancelling(const std::vector<formula::Tree>& sides, const Values& letters);
  /// Which of the letters occur.
  static std::vector<bool> used(const std::vector<formula::Tree>& sides, std::size_t letters);

 private:
  struct Read {
    formula::Names names;
    std::vector<formula::Tree> sides;
    std::vector<bool> used;  ///< which of the letters occur
  };
  const Read& read(const TypesetLetters&) const;
  std::string text_;
  mutable std::shared_ptr<const Read> read_ = nullptr;
};

/// A relation, \ddot q<0 or x_1=x_2=0, and whether it is true; for tuples, in every component. Equality is to
/// a billionth of the terms that are added up. Nullopt if a side cannot be evaluated or there is only one.
class TypesetRelation {
 public:
  /// Parses at the first evaluation.
  explicit TypesetRelation(std::string_view text);
  std::optional<bool> operator()(const TypesetLetters&) const;

 private:
  struct Read;
  std::shared_ptr<Read> read_;
};
inline std::optional<bool> typeset_relation(std::string_view text, const TypesetLetters& letters) {
  return TypesetRelation(text)(letters);
}

/// Forms of one quantity in a row: a single number next to several is repeated.
void in_a_row(Value& a, Value& b);

using formula::is_formula;

/// Result of comparing a text with the computed values.
struct Typesetting {
  bool read = false;            ///< the text is a formula of the known letters and agrees
  std::string difference = {};  ///< how it disagrees
  /// If the computed values equal one side of an equation: how another side differs. Set for false equations
  /// too.
  std::string unequal = {};
};

/// Compares a text with the values computed at some samples. An equation may represent one of its sides,
/// except a single letter on its left, several of them in a row, or the difference of two.
Typesetting compare_typeset(const std::string& text,
                            const std::vector<std::pair<TypesetLetters, Value>>& computed);

/// Compares a text with whether it should be true at each of some samples.
Typesetting compare_typeset(const std::string& text,
                            const std::vector<std::pair<TypesetLetters, bool>>& said);

/// Whether the text has been read. Throws std::logic_error if it disagrees.
bool is_as_typeset(const Typesetting&);

}  // namespace oddity
