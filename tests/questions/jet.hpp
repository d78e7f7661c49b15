#pragma once

#include <array>
#include <cmath>
#include <cstddef>

/// Numbers that carry their first and second derivatives.
namespace questions {

using Real = long double;

/// A function of n variables to second order about a point.
template <std::size_t n>
struct Jet {
  Real x = 0;
  std::array<Real, n> d = {};
  std::array<Real, n*(n + 1) / 2> dd = {};  ///< the lower triangle, row by row

  Jet() = default;
  Jet(Real value) : x(value) {}
  static Jet variable(Real value, std::size_t i) {
    Jet jet(value);
    jet.d[i] = 1;
    return jet;
  }
  /// f of this jet, from f's value and derivatives.
  Jet through(Real f, Real f1, Real f2) const {
    Jet r(f);
    for (std::size_t i = 0, k = 0; i < n; ++i) {
      r.d[i] = f1 * d[i];
      for (std::size_t j = 0; j <= i; ++j, ++k) r.dd[k] = f1 * dd[k] + f2 * d[i] * d[j];
    }
    return r;
  }
  friend Jet operator+(Jet a, const Jet& b) {
    a.x += b.x;
    for (std::size_t i = 0; i < n; ++i) a.d[i] += b.d[i];
    for (std::size_t k = 0; k < a.dd.size(); ++k) a.dd[k] += b.dd[k];
    return a;
  }
  friend Jet operator*(const Jet& a, const Jet& b) {
    Jet r(a.x * b.x);
    for (std::size_t i = 0, k = 0; i < n; ++i) {
      r.d[i] = a.d[i] * b.x + a.x * b.d[i];
      for (std::size_t j = 0; j <= i; ++j, ++k)
        r.dd[k] = a.dd[k] * b.x + a.x * b.dd[k] + a.d[i] * b.d[j] + a.d[j] * b.d[i];
    }
    return r;
  }
  friend Jet operator-(const Jet& a) { return a.through(-a.x, -1, 0); }
  friend Jet operator-(const Jet& a, const Jet& b) { return a + -b; }
  friend Jet operator/(const Jet& a, const Jet& b) {
    const Real q = 1 / b.x;
    return a * b.through(q, -q * q, 2 * q * q * q);
  }
  friend Jet sin(const Jet& a) { return a.through(std::sin(a.x), std::cos(a.x), -std::sin(a.x)); }
  friend Jet cos(const Jet& a) { return a.through(std::cos(a.x), -std::sin(a.x), -std::cos(a.x)); }
  friend Jet sqrt(const Jet& a) {
    const Real r = std::sqrt(a.x);
    return a.through(r, 1 / (2 * r), -1 / (4 * r * a.x));
  }
};

}  // namespace questions
