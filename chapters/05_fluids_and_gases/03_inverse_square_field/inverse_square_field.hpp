#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "chapters/05_fluids_and_gases/shared/fields.hpp"
#include "chapters/exercise.hpp"
#include "chapters/foreseen.hpp"

/// The field x / |x|^3, its derivatives as published, and its flux through closed surfaces.
namespace oddity::ex05_03 {

using fields::Point, fields::Triple;

inline constexpr auto inverse_square = []<class T>(const Triple<T>& x) {
  using std::sqrt;
  const T r = sqrt(dot(x, x)), cube = r * r * r;
  return Triple<T>{x[0] / cube, x[1] / cube, x[2] / cube};
};

/// A published formula for the three derivatives; s is x.x, x is one of the coordinates.
template <double (*derivative)(double s, double x)>
Point each(const Point& x) {
  const double s = dot(x, x);
  return {derivative(s, x[0]), derivative(s, x[1]), derivative(s, x[2])};
}
/// s to the power of exponent / 2.
template <class T>
T half_power(const T& s, int exponent) {
  if constexpr (std::same_as<T, double>)
    return std::pow(s, exponent / 2.0);
  else
    return pow(sqrt(s), exponent);
}
template <class T>
T quotient(T s, T x) {
  return (half_power(s, 3) - 3 * x * x * half_power(s, 1)) / half_power(s, 6);
}
template <class T>
T simplified(T s, T x) {
  return (s - 3 * x * x) / half_power(s, 5);
}
/// The three summands over the common denominator.
template <class T>
Triple<T> brackets(const Triple<T>& x) {
  const T s = x[0] * x[0] + x[1] * x[1] + x[2] * x[2], denominator = half_power(s, 5);
  return {(s - 3 * x[0] * x[0]) / denominator, (s - 3 * x[1] * x[1]) / denominator,
          (s - 3 * x[2] * x[2]) / denominator};
}
/// The brackets |x|^2 - factor x_i^2.
template <class T>
T sum_of_brackets(const Triple<T>& x, T factor) {
  const T s = dot(x, x);
  return (s - factor * x[0] * x[0]) + (s - factor * x[1] * x[1]) + (s - factor * x[2] * x[2]);
}

std::vector<Claim> claims(const Random&, const Reference&);
Provables proofs();
std::vector<Root> roots();

Quantity partials(const std::string& name, const std::string& says, const Point& x, const Reference&);
/// Outcome of the quotient rule as printed, which has |x|^6 below.
Foreseen by_quotient_rule(const Point& x);

/// The flux through a spheroid of semi-axes a, a, b, with its centre d along b, by several rules. `peaked`:
/// rules with fixed points miss the peak of the density, as the origin is close to the surface.
Quantity spheroid_flux(const std::string& name, const std::string& says, double a, double b, double d,
                       const Reference&, bool peaked = false);
/// The flux through a cube of half side h with its centre at (h/4, -h/2, h/8).
Quantity cube_flux(double h, const Reference&);

}  // namespace oddity::ex05_03
