#pragma once

#include <cmath>
#include <concepts>

#include "chapters/expression.hpp"

/// Further functions of a recording number, with the facts about them that Coq needs.
namespace oddity {

inline Shortened acos(const Shortened& x) { return function("acos", x.expression()); }
/// Needs atan2.v.
inline Shortened atan2(const Shortened& y, const Shortened& x) {
  return Expression::letter("(atan2 (" + y.expression().coq() + ") (" + x.expression().coq() + "))");
}
inline Shortened hypot(const Shortened& x, const Shortened& y, const Shortened& z) {
  return sqrt(x * x + y * y + z * z);
}

/// x^n for x > 0 and n a multiple of one half.
template <class T>
T half_power(const T& x, double n) {
  if constexpr (std::same_as<T, Shortened>)
    return n == std::floor(n) ? pow(x, static_cast<int>(n)) : pow(sqrt(x), static_cast<int>(2 * n));
  else
    return std::pow(x, n);
}

}  // namespace oddity
