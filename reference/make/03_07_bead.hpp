#pragma once

#include "reference/make/extrapolation.hpp"
#include "reference/make/routes.hpp"
#include "reference/make/taylor.hpp"

/// The bead on the curve (q, q^2, q^3), released at rest at q0, by two independent routes.
namespace oddity::truth {

/// (x, y, z, x', y', z') as a point under gravity held by y - x^2 = 0 and z - x^3 = 0. Both constraints are
/// differentiated twice; Cramer's rule gives their two multipliers.
struct HeldBead {
  Number g;

  template <class T>
  std::vector<T> operator()(const std::vector<T>& s, const T&) const {
    const T &x = s[0], &v = s[3];
    const T x2 = x * x, x3 = x2 * x, x4 = x2 * x2, v2 = v * v;
    const T r1 = Number(2) * v2, r2 = Number(6) * x * v2 + g;
    const T g11 = Number(4) * x2 + Number(1), g12 = Number(6) * x3, g22 = Number(9) * x4 + Number(1);
    const T determinant = Number(9) * x4 + Number(4) * x2 + Number(1);  // g11 g22 - g12^2
    const T m1 = (g22 * r1 - g12 * r2) / determinant, m2 = (g11 * r2 - g12 * r1) / determinant;
    return {s[3], s[4], s[5], -(Number(2) * x * m1) - Number(3) * x2 * m2, m1, m2 - g};
  }
};

/// dt/du by conservation of energy, q = q0 (1 - u^2): smooth at the bead's start.
template <class T>
T seconds_per_u(const Number& q0, const Number& g, const T& u) {
  const T q = q0 * (1 - u * u);
  return 2 * sqrt(q0) * sqrt((1 + 4 * q * q + 9 * q * q * q * q) / (2 * g * (q0 * q0 + q0 * q + q * q)));
}

}  // namespace oddity::truth
