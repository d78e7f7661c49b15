#pragma once

#include <cmath>
#include <vector>

#include "chapters/exercise.hpp"

/// What the files of exercise 3.1 share.
namespace oddity::ex03_01 {

template <class T>
T orbit(double e, double rho, const T& theta) {
  using std::cos;
  return e * rho / (1.0 + e * cos(theta));
}

/// The ellipse (x + c)^2/a^2 + y^2/b^2 = 1 of an orbit.
struct Ellipse {
  double e, rho;
  double q() const { return (1 - e) * (1 + e); }
  double a() const { return e * rho / q(); }
  double b() const { return a() * std::sqrt(q()); }
  double c() const { return e * e * rho / q(); }
};

// claims.cpp
std::vector<Claim> claims(double seed);
std::vector<Root> roots();

}  // namespace oddity::ex03_01
