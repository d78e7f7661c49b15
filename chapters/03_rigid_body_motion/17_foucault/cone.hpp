#pragma once

#include <cmath>

/// Formulas of the cone of 3.17, generic in the number type: evaluated by the claims, and recorded for their
/// proofs.
namespace oddity::ex03_17 {

/// The radius at the height z above the base.
template <class T>
T radius(const T& r, const T& h, const T& z) {
  return r * (1 - z / h);
}
/// Fractions of the cone's height: the printed position of the center of mass, and its distance from the
/// vertex.
template <class T>
T printed_length() {
  using std::cbrt;
  return 1 / cbrt(T(2));
}
template <class T>
T halving_height() {
  return 1 - printed_length<T>();
}
/// Fraction of the cone's volume above its center of mass.
template <class T>
T above_center() {
  return T(27) / 64;
}

}  // namespace oddity::ex03_17
