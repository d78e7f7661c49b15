#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "chapters/exercise.hpp"

/// The integral of exercise 3.5, and its claims.
namespace oddity::ex03_05 {

inline constexpr double book_angle = std::numbers::pi / 6;
inline constexpr double book_epsilon = 1e-8;
inline constexpr int book_panels = 1024;

/// The integrand after sin(t/2) = k sin(u): smooth on [0, pi/2].
template <class T>
auto legendre_integrand(const T& a) {
  using std::sin, std::sqrt;
  const T k = sin(a / 2), root = sqrt(T(2));
  return [k, root](const T& u) { return root / sqrt(1 - k * k * sin(u) * sin(u)); };
}

/// The book's integral over the last epsilon, to leading order.
inline double remainder(double a, double epsilon) {
  using std::cos, std::sin;
  return std::sqrt(2 / cos(a)) * (std::numbers::pi / 2 - std::asin(1 - epsilon * cos(a) / sin(a)));
}

/// The listing's arithmetic, in the listing's order; `shift` is subtracted from the cosine.
double listed_integral(double a, double shift, int panels);

std::vector<Claim> claims(const Reference&);
Provables proofs();
std::vector<Root> roots();

}  // namespace oddity::ex03_05
