#pragma once

#include "chapters/expression.hpp"

namespace oddity {

/// An expression without the terms that are zero and the factors that are one, of which dual numbers make
/// many.
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
  friend Shortened pow(const Shortened& x, int exponent) { return pow(x.all_, exponent); }
  friend Shortened sqrt(const Shortened& x) { return sqrt(x.all_); }
  friend Shortened sin(const Shortened& x) { return sin(x.all_); }
  friend Shortened cos(const Shortened& x) { return cos(x.all_); }
  friend Shortened abs(const Shortened& x) { return abs(x.all_); }
  friend Shortened exp(const Shortened& x) { return exp(x.all_); }

 private:
  bool is(std::string_view number) const { return all_.coq() == number; }
  Expression all_;
};

}  // namespace oddity
