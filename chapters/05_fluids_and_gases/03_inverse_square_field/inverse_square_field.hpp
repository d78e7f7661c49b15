#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "chapters/05_fluids_and_gases/shared/fields.hpp"
#include "chapters/exercise.hpp"

/// The field x / |x|^3, its derivatives as published, and its flux through closed surfaces.
namespace oddity::ex05_03 {

using fields::Point, fields::Triple;

inline constexpr auto inverse_square = []<class T>(const Triple<T>& x) {
  using std::sqrt;
  const T r = sqrt(dot(x, x)), cube = r * r * r;
  return Triple<T>{x[0] / cube, x[1] / cube, x[2] / cube};
};

/// A published formula for the three derivatives; s is x.x, x one of the coordinates.
template <double (*derivative)(double s, double x)>
Point each(const Point& x) {
  const double s = dot(x, x);
  return {derivative(s, x[0]), derivative(s, x[1]), derivative(s, x[2])};
}
inline double quotient(double s, double x) {
  return (std::pow(s, 1.5) - 3 * x * x * std::pow(s, 0.5)) / std::pow(s, 3);
}
inline double simplified(double s, double x) { return (s - 3 * x * x) / std::pow(s, 2.5); }

std::vector<Claim> claims(const Random&, const Reference&);
std::vector<Root> roots();

/// How differences with an absolute step are expected to end.
struct Steps {
  Outcome second = Outcome::inaccurate, fourth = Outcome::inaccurate;
  std::string why = "rounding grows as $1/h$: the finest step is not the best";
};

Quantity partials(const std::string& name, const std::string& says, const Point& x, const Reference&,
                  Outcome quotient_ends, const Steps& absolute);

/// The flux through a spheroid of semi-axes a, a, b, its centre d along b, by several rules; `peaked`: the
/// origin is so close to the surface that rules with fixed points miss the peak of the density.
Quantity spheroid_flux(const std::string& name, const std::string& says, double a, double b, double d,
                       const Reference&, bool peaked = false);
/// The flux through a cube of half side h, its centre at (h/4, -h/2, h/8).
Quantity cube_flux(double h, const Reference&);

}  // namespace oddity::ex05_03
