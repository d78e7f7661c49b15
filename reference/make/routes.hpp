#pragma once

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <stdexcept>

#include "reference/truth.hpp"

/// Tools that several tables are made with.
namespace oddity::truth {

inline Number pi() { return acos(Number(-1)); }

/// The complete elliptic integral of the first kind, K(k), by the arithmetic-geometric mean [DLMF 19.8.5].
/// Throws std::domain_error unless |k| < 1.
inline Number elliptic_k(const Number& k) {
  if (!(abs(k) < 1)) throw std::domain_error("K(k) needs |k| < 1");
  Number a = 1, b = sqrt(1 - k * k);
  while (abs(a - b) > pow(Number(10), 3 - static_cast<int>(working_digits))) {
    const Number mean = (a + b) / 2;
    b = sqrt(a * b);
    a = mean;
  }
  return pi() / (a + b);
}

/// The integral of f over [a, b] by double-exponential quadrature; f is never called at a or b, and may be
/// infinite there.
template <class F>
Number integral(const F& f, const Number& a, const Number& b, int digits) {
  boost::math::quadrature::tanh_sinh<Number> rule(15, pow(Number(10), -120));
  return rule.integrate(f, a, b, Number(pow(Number(10), -digits - 4)));
}

}  // namespace oddity::truth
