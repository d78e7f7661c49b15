#pragma once

#include <cmath>
#include <vector>

#include "chapters/exercise.hpp"

/// Shared by the files of exercise 3.1.
namespace oddity::ex03_01 {

template <class T, class Angle>
Angle orbit(const T& e, const T& rho, const Angle& theta) {
  using std::cos;
  return e * rho / (1.0 + e * cos(theta));
}

/// The ellipse (x + c)^2/a^2 + y^2/b^2 = 1 of an orbit.
template <class T>
struct EllipseOf {
  T e, rho;
  T q() const { return (1 - e) * (1 + e); }
  T a() const { return e * rho / q(); }
  T b() const {
    using std::sqrt;
    return a() * sqrt(q());
  }
  T c() const { return e * e * rho / q(); }
};
using Ellipse = EllipseOf<double>;

// claims.cpp
std::vector<Claim> claims(double seed);
Provables proofs();
std::vector<Root> roots();

}  // namespace oddity::ex03_01
