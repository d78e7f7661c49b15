#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <vector>

#include "formula/evaluate.hpp"

namespace oddity::formula {

/// A number with the size of its terms: the sum of their absolute values. Roundings are of this size, even if
/// the terms cancel.
struct Sized {
  double value = 0, size = 0;

  Sized() = default;
  Sized(double x) : value(x), size(std::abs(x)) {}
  Sized(double x, double terms) : value(x), size(std::max(std::abs(x), terms)) {}

  friend Sized operator+(Sized a, Sized b) { return {a.value + b.value, a.size + b.size}; }
  friend Sized operator-(Sized a, Sized b) { return {a.value - b.value, a.size + b.size}; }
  friend Sized operator-(Sized a) { return {-a.value, a.size}; }
  friend Sized operator*(Sized a, Sized b) { return {a.value * b.value, a.size * b.size}; }
  friend Sized operator/(Sized a, Sized b) {
    const double below = std::abs(b.value);
    return {a.value / b.value, a.size / below * std::max(1.0, b.size / below)};
  }
  friend bool operator<(Sized a, Sized b) { return a.value < b.value; }
};

/// A function multiplies its argument's error by its slope.
inline Sized with_slope(double value, double slope, const Sized& x) {
  return {value, std::abs(value) + std::abs(slope) * x.size};
}
inline Sized sin(const Sized& x) { return with_slope(std::sin(x.value), std::cos(x.value), x); }
inline Sized cos(const Sized& x) { return with_slope(std::cos(x.value), std::sin(x.value), x); }
inline Sized tan(const Sized& x) {
  const double t = std::tan(x.value);
  return with_slope(t, 1 + t * t, x);
}
inline Sized asin(const Sized& x) {
  return with_slope(std::asin(x.value), 1 / std::sqrt(1 - x.value * x.value), x);
}
inline Sized acos(const Sized& x) {
  return with_slope(std::acos(x.value), 1 / std::sqrt(1 - x.value * x.value), x);
}
inline Sized atan(const Sized& x) { return with_slope(std::atan(x.value), 1 / (1 + x.value * x.value), x); }
inline Sized exp(const Sized& x) { return with_slope(std::exp(x.value), std::exp(x.value), x); }
inline Sized log(const Sized& x) { return with_slope(std::log(x.value), 1 / x.value, x); }
inline Sized sqrt(const Sized& x) {
  const double root = std::sqrt(x.value);
  return with_slope(root, root > 0 ? 0.5 / root : 0, x);
}
inline Sized abs(const Sized& x) { return {std::abs(x.value), x.size}; }
inline Sized pow(const Sized& x, int n) { return detail::whole_power(x, n); }

/// The largest of the components' sizes.
inline double magnitude(const Tree& x, const std::vector<Matrix<double>>& letters) {
  std::vector<Matrix<Sized>> sized;
  for (const Matrix<double>& letter : letters)
    sized.push_back({std::vector<Sized>(letter.entries.begin(), letter.entries.end()), letter.columns});
  double largest = 0;
  for (const Sized& one : evaluate(x, sized).entries) {
    if (std::isnan(one.size)) return one.size;
    largest = std::max(largest, one.size);
  }
  return largest;
}

}  // namespace oddity::formula
