#pragma once

#include <string>
#include <vector>

#include "formula/tree.hpp"

namespace oddity::formula {

/// Prints a tree from its parts in one notation. Puts parentheses around parts that bind weaker than their
/// place.
class Writer {
 public:
  virtual ~Writer() = default;
  std::string of(const Tree& x) { return written(x, Level::sum); }

 protected:
  /// From the weakest binding to the strongest.
  enum class Level { sum, cross, product, factor, base };
  using Parts = std::vector<std::string>;

  virtual std::string number(const std::string& digits) = 0;
  virtual std::string letter(const std::string& name) = 0;
  /// pm, mp, dot, cross, pi, comma, semicolon, or a sign itself. `prefix`: it begins a sum.
  virtual std::string sign(const std::string& name, bool prefix = false) = 0;
  virtual std::string side_by_side(const std::string& left, const std::string& right) = 0;
  virtual std::string apart(const std::string& left, const std::string& right) { return left + " " + right; }
  virtual std::string bar(const std::string& left, const std::string& right) = 0;
  virtual std::string fraction(const Tree& above, const Tree& below) = 0;
  virtual std::string power(const std::string& base, const Tree& exponent) = 0;
  virtual std::string transposed(const std::string& base) = 0;
  virtual std::string function(const std::string& name, const std::string& exponent, const Tree& x) = 0;
  /// `degree` is empty for a square root.
  virtual std::string root(const Tree& x, const std::string& degree) = 0;
  /// Double bars if `twice`.
  virtual std::string bars(const Tree& x, bool twice) = 0;
  virtual std::string parentheses(const std::string& inside) = 0;
  virtual std::string matrix(const std::vector<Parts>& rows, const std::string& environment) = 0;
  virtual std::string named(const std::string& name, const std::string& inside) = 0;
  virtual std::string sum_over(const std::string& index, const std::string& last,
                               const std::string& body) = 0;
  virtual std::string integral(const Tree& x) = 0;
  virtual std::string along_curve(const Tree& x) = 0;
  virtual std::string time_derivative(const std::string& x) = 0;
  // For shown formulas only. Commands are TeX's.
  virtual std::string brackets(const std::string& opening, const std::string& inside,
                               const std::string& closing) = 0;
  virtual std::string indexed(const std::string& base, const std::string& scripts) = 0;
  virtual std::string relation(const std::string& command) = 0;
  virtual std::string large(const std::string& command, const Tree& below, const Tree* above) = 0;
  virtual std::string words(const std::string& text) = 0;
  virtual std::string upright(const Tree& x) { return of(x); }
  virtual std::string marked(const std::string& inside) { return inside; }

  /// Whether a fraction needs no parentheses as a factor.
  virtual bool fraction_is_factor() const = 0;

  std::string written(const Tree& x, Level place);
  /// Whether a function needs no brackets around it: \sin\omega t, or arguments in brackets.
  static bool is_plain_argument(const Tree& x);
  /// The sign before a term of a sum, which may be marked as different.
  std::string sign_of_term(const Tree& sum, std::size_t term);
  std::string term(const Tree& x);

 private:
  Level level_of(const Tree& x) const;
  std::string bare(const Tree& x);
  std::string sum(const Tree& x);
  std::string product(const Tree& x);
  std::string tuple(const Tree& x);
};

}  // namespace oddity::formula
