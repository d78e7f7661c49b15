#pragma once

#include <cmath>

/// Of 3.5, generic in the number type: evaluated by the methods, and recorded for its proof.
namespace oddity::ex03_05 {

/// The quarter period's integrand after sin(t/2) = sin(a/2) sin(u): smooth on [0, pi/2].
template <class T>
auto legendre_integrand(const T& a) {
  using std::sin, std::sqrt;
  const T k = sin(a / 2);
  return [k](const auto& u) { return sqrt(T(2)) / sqrt(1 - k * k * sin(u) * sin(u)); };
}

}  // namespace oddity::ex03_05
