#pragma once

#include <cmath>

/// Of the cone of 3.17, generic in the number type: evaluated by the claims, and recorded for their proofs.
namespace oddity::ex03_17 {

/// At the height z over the base.
template <class T>
T radius(const T& r, const T& h, const T& z) {
  return r * (1 - z / h);
}
/// Of the cone's height: what is printed for its center of mass, and for the center's distance from the
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
/// Of the cone's volume: what lies above its center of mass.
template <class T>
T above_center() {
  return T(27) / 64;
}

}  // namespace oddity::ex03_17
