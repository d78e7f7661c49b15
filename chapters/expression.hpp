#pragma once

#include <concepts>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// A number that records its computation in the syntax of the proof assistant Coq. So one formula, generic in
/// its number type, is both checked in double and proved.
namespace oddity {

class Expression {
 public:
  Expression() : Expression(0.0) {}
  /// The shortest decimal that reads back as the same double, as an exact fraction. Throws std::logic_error
  /// if it is not finite.
  Expression(double);
  /// A letter, or a term with the precedence of a letter.
  static Expression letter(std::string name) { return {std::move(name), Level::atom}; }

  const std::string& coq() const { return text_; }

  friend Expression operator+(const Expression&, const Expression&);
  friend Expression operator-(const Expression&, const Expression&);
  friend Expression operator*(const Expression&, const Expression&);
  friend Expression operator/(const Expression&, const Expression&);
  friend Expression operator-(const Expression&);
  Expression& operator+=(const Expression& x) { return *this = *this + x; }
  friend Expression pow(const Expression&, int exponent);
  friend Expression function(std::string_view name, const Expression&);

 private:
  /// From the strongest binding to the weakest.
  enum class Level { atom, power, sign, product, sum };
  Expression(std::string text, Level level) : text_(std::move(text)), level_(level) {}
  /// The text, in parentheses unless it binds at least as strongly as this level.
  std::string within(Level) const;

  std::string text_;
  Level level_;
};

inline Expression sqrt(const Expression& x) { return function("sqrt", x); }
inline Expression sin(const Expression& x) { return function("sin", x); }
inline Expression cos(const Expression& x) { return function("cos", x); }
inline Expression exp(const Expression& x) { return function("exp", x); }
inline Expression log(const Expression& x) { return function("ln", x); }
inline Expression atan(const Expression& x) { return function("atan", x); }
inline Expression abs(const Expression& x) { return function("Rabs", x); }

/// For a positive number.
inline Expression cbrt(const Expression& x) {
  return Expression::letter("(Rpower (" + x.coq() + ") (1 / 3))");
}
inline Expression pi_in_coq() { return Expression::letter("PI"); }

/// The integral of `integrand` over the letter `name`.
template <class F>
Expression integral(const F& integrand, const Expression& from, const Expression& to,
                    const std::string& name) {
  const std::string inner = integrand(Expression::letter(name)).coq();
  return Expression::letter("(RInt (fun " + name + " => " + inner + ") (" + from.coq() + ") (" + to.coq() +
                            "))");
}

/// An expression without terms that are zero and factors that are one, of which dual numbers make many.
class Shortened {
 public:
  Shortened() = default;
  Shortened(double x) : all_(x) {}
  Shortened(Expression x) : all_(std::move(x)) {}
  static Shortened letter(std::string name) { return Expression::letter(std::move(name)); }
  const Expression& expression() const { return all_; }

  friend Shortened operator+(const Shortened& a, const Shortened& b) {
    if (a.is("0")) return b;
    return b.is("0") ? a : Shortened(a.all_ + b.all_);
  }
  friend Shortened operator-(const Shortened& a, const Shortened& b) {
    if (a.is("0")) return -b;
    return b.is("0") ? a : Shortened(a.all_ - b.all_);
  }
  friend Shortened operator*(const Shortened& a, const Shortened& b) {
    if (a.is("0") || b.is("1")) return a;
    return b.is("0") || a.is("1") ? b : Shortened(a.all_ * b.all_);
  }
  friend Shortened operator/(const Shortened& a, const Shortened& b) {
    return a.is("0") || b.is("1") ? a : Shortened(a.all_ / b.all_);
  }
  friend Shortened operator-(const Shortened& a) { return a.is("0") ? a : Shortened(-a.all_); }
  Shortened& operator+=(const Shortened& x) { return *this = *this + x; }
  Shortened& operator-=(const Shortened& x) { return *this = *this - x; }
  Shortened& operator*=(const Shortened& x) { return *this = *this * x; }
  Shortened& operator/=(const Shortened& x) { return *this = *this / x; }
  friend Shortened pow(const Shortened& x, int exponent) { return pow(x.all_, exponent); }
  friend Shortened sqrt(const Shortened& x) { return sqrt(x.all_); }
  friend Shortened sin(const Shortened& x) { return sin(x.all_); }
  friend Shortened cos(const Shortened& x) { return cos(x.all_); }
  friend Shortened hypot(const Shortened& x, const Shortened& y) { return sqrt(x * x + y * y); }
  friend Shortened abs(const Shortened& x) { return abs(x.all_); }
  friend Shortened exp(const Shortened& x) { return exp(x.all_); }
  friend Shortened cbrt(const Shortened& x) { return cbrt(x.all_); }

 private:
  bool is(std::string_view number) const { return all_.coq() == number; }
  Expression all_;
};

/// Pi; exact if numbers are expressions.
template <class T>
T pi_of() {
  if constexpr (std::same_as<T, Shortened>)
    return pi_in_coq();
  else
    return T(std::numbers::pi);
}

using Expressions = std::vector<Expression>;

}  // namespace oddity
