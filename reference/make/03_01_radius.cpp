#include <cmath>

#include "reference/make/routes.hpp"

// The conic with focus at the origin, eccentricity e and semi-latus rectum p, on the ray at angle theta:
// r = p/(1 + e cos theta). The second route uses only the condition that the distance to the focus is e times
// that to the directrix x = p/e. Squared it is x^2 + y^2 = (p - e x)^2.
namespace oddity::truth {

namespace radius_03_01 {

Numbers by_polar_equation(const std::vector<double>& in, int) {
  return {in[1] / (1 + in[0] * cos(Number(in[2])))};
}

/// The first zero along the ray of r^2 - (p - e x)^2, which is negative at the focus. Every later zero is on
/// a hyperbola's other branch, beyond the directrix, with p - e x < 0.
Numbers by_bisection(const std::vector<double>& in, int digits) {
  const Number e = in[0], p = in[1], c = cos(Number(in[2])), s = sin(Number(in[2]));
  const auto outside = [&](const Number& r) {
    const Number x = r * c, y = r * s, to_directrix = p - e * x;
    return to_directrix <= 0 || x * x + y * y > to_directrix * to_directrix;
  };
  Number low = 0, high = p;
  while (!outside(high)) high *= 2;
  while (high - low > high * pow(Number(10), -digits - 4)) {
    const Number middle = (low + high) / 2;
    (outside(middle) ? high : low) = middle;
  }
  return {(low + high) / 2};
}

}  // namespace radius_03_01

Truth truth_03_01_radius() {
  using namespace radius_03_01;
  return {
      "distance from the focus, at the polar angle theta, of the conic of eccentricity e and semi-latus "
      "rectum p = e rho",
      "r = p / (1 + e cos theta)",
      {"e", "p", "theta"},
      {{"r", "1"}},
      {{0.625, 0.9375, 2.25},
       {0, 1.5, 2.25},
       {0.984375, 0.25, 3},
       {1 - std::ldexp(1.0, -30), 1, 1.5},
       {1, 1, std::ldexp(1.0, -10)},
       {1.5, 1, 1.25}},
      "polar equation",
      by_polar_equation,
      "bisection along the ray for x^2 + y^2 = (p - e x)^2",
      by_bisection,
      "the first route",
      by_polar_equation};
}

}  // namespace oddity::truth
