#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formula/evaluate.hpp"
#include "formula/parse.hpp"
#include "formula/tokens.hpp"

/// Formulas as code: a number type whose operations record their text in another language. Sums over indices,
/// products of matrices and derivatives are written out.
namespace oddity::formula {

struct Cpp {
  static std::string number(double);  ///< 2.0, so that 1/2 is not a division of integers
  static std::string function(std::string_view name, const std::string& x);
  static std::string power(const std::string& x, int exponent);
  static constexpr std::string_view pi = "std::numbers::pi";
};
struct CSharp {
  static std::string number(double);
  static std::string function(std::string_view name, const std::string& x);
  static std::string power(const std::string& x, int exponent);
  static constexpr std::string_view pi = "Math.PI";
};
struct JavaScript {
  static std::string number(double);
  static std::string function(std::string_view name, const std::string& x);
  static std::string power(const std::string& x, int exponent);
  static constexpr std::string_view pi = "Math.PI";
};
struct Coq {
  static std::string number(double);
  static std::string function(std::string_view name, const std::string& x);
  static std::string power(const std::string& x, int exponent);
  static constexpr std::string_view pi = "PI";
};

/// A term of a language. Omits zeros in sums and ones in products.
template <class Language>
class Code {
 public:
  Code() : Code(0.0) {}
  Code(double x) : Code(Language::number(x < 0 ? -x : x), Level::atom) {
    if (x < 0) *this = -*this;
  }
  static Code term(std::string text) { return {std::move(text), Level::atom}; }
  const std::string& text() const { return text_; }

  friend Code operator+(const Code& a, const Code& b) {
    if (a.is(0)) return b;
    if (b.is_negative()) return a - b.without_sign();
    return b.is(0) ? a : Code(a.text_ + " + " + b.within(Level::product), Level::sum);
  }
  friend Code operator-(const Code& a, const Code& b) {
    if (a.is(0)) return -b;
    if (b.is_negative()) return a + b.without_sign();
    return b.is(0) ? a : Code(a.text_ + " - " + b.within(Level::product), Level::sum);
  }
  friend Code operator*(const Code& a, const Code& b) {
    if (a.is(0) || b.is(1)) return a;
    if (b.is(0) || a.is(1)) return b;
    return {a.within(Level::product) + " * " + b.within(Level::sign), Level::product};
  }
  friend Code operator/(const Code& a, const Code& b) {
    if (a.is(0) || b.is(1)) return a;
    return {a.within(Level::product) + " / " + b.within(Level::sign), Level::product};
  }
  friend Code operator-(const Code& a) {
    return a.is(0) ? a : Code("-" + std::string(spaced ? " " : "") + a.within(Level::atom), Level::sign);
  }
  friend Code pow(const Code& x, int exponent) {
    if (exponent < 0) return Code(1.0) / pow(x, -exponent);
    if (exponent == 0) return Code(1.0);
    if (exponent == 1) return x;
    return {Language::power(x.within(Level::atom), exponent), Level::power};
  }
  static Code function(std::string_view name, const Code& x) {
    return {Language::function(name, x.text_), spaced ? Level::power : Level::atom};
  }

 private:
  /// From the strongest binding to the weakest.
  enum class Level { atom, power, sign, product, sum };
  static constexpr bool spaced = std::same_as<Language, Coq>;

  Code(std::string text, Level level) : text_(std::move(text)), level_(level) {
    if (level == Level::atom && text_.find(" / ") != std::string::npos && !text_.ends_with(')'))
      level_ = Level::product;
  }
  /// A product whose first factor has a sign; of a sum, that is the sign of its first term.
  bool is_negative() const { return !spaced && level_ < Level::sum && text_.starts_with('-'); }
  Code without_sign() const { return {text_.substr(1), Level::product}; }
  bool is(int x) const { return text_ == Language::number(x); }
  std::string within(Level level) const { return level_ <= level ? text_ : "(" + text_ + ")"; }

  std::string text_;
  Level level_;
};

#define ODDITY_CODE_FUNCTION(f, written)         \
  template <class Language>                      \
  Code<Language> f(const Code<Language>& x) {    \
    return Code<Language>::function(written, x); \
  }
ODDITY_CODE_FUNCTION(sin, "sin")
ODDITY_CODE_FUNCTION(cos, "cos")
ODDITY_CODE_FUNCTION(tan, "tan")
ODDITY_CODE_FUNCTION(asin, "asin")
ODDITY_CODE_FUNCTION(acos, "acos")
ODDITY_CODE_FUNCTION(atan, "atan")
ODDITY_CODE_FUNCTION(sinh, "sinh")
ODDITY_CODE_FUNCTION(cosh, "cosh")
ODDITY_CODE_FUNCTION(tanh, "tanh")
ODDITY_CODE_FUNCTION(exp, "exp")
ODDITY_CODE_FUNCTION(log, "log")
ODDITY_CODE_FUNCTION(sqrt, "sqrt")
ODDITY_CODE_FUNCTION(abs, "abs")
#undef ODDITY_CODE_FUNCTION

template <class Language>
struct Constants<Code<Language>> {
  static Code<Language> pi() { return Code<Language>::term(std::string(Language::pi)); }
};

/// A formula's components in a language. Letters that are numbers have the given names, or else their plain
/// names with _dot for a prime.
std::string code_name(std::string_view letter);
template <class Language>
std::vector<std::string> code(const Tree& x, const Names& letters,
                              const std::vector<std::string>& names = {}) {
  std::vector<Matrix<Code<Language>>> terms;
  for (std::size_t i = 0; i < letters.size(); ++i)
    terms.push_back({{Code<Language>::term(i < names.size() ? names[i] : code_name(letters[i]))}});
  std::vector<std::string> all;
  for (const Code<Language>& one : evaluate(x, terms).entries) all.push_back(one.text());
  return all;
}

}  // namespace oddity::formula
