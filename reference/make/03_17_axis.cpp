#include "reference/make/03_17_foucault.hpp"
#include "reference/make/routes.hpp"

// The bob's ellipse at small amplitude, from position and velocity: x + i y = a exp(i w t) + b exp(-i w t),
// w = sqrt(g/L). Its major axis has the direction of sqrt(a b).
namespace oddity::truth {

namespace axis_03_17 {

Numbers from_the_product(const std::vector<double>& in, const Numbers& s) {
  const Number m = Number(in[1]) / Number(in[3]);
  return {atan2(Number(2 * (s[0] * s[1] + m * s[3] * s[4])),
                Number(s[0] * s[0] - s[1] * s[1] + m * (s[3] * s[3] - s[4] * s[4]))) /
          2};
}

Numbers by_product(const std::vector<double>& in, Precision digits) {
  return from_the_product(in, foucault::by_taylor(in, digits));
}

/// The mean of the directions of a and b, reduced to within a quarter turn.
Numbers from_the_circles(const std::vector<double>& in, const Numbers& s) {
  const Number w = sqrt(Number(in[3]) / Number(in[1])), half_turn = pi();
  const Number a = atan2(Number(s[1] - s[3] / w), Number(s[0] + s[4] / w));
  const Number b = atan2(Number(s[1] + s[3] / w), Number(s[0] - s[4] / w));
  const Number mean = (a + b) / 2;
  return {mean - half_turn * round(Number(mean / half_turn))};
}

}  // namespace axis_03_17

Truth truth_03_17_axis() {
  using namespace axis_03_17;
  return {"direction, from west to north, of the major axis of a Foucault pendulum's ellipse",
          foucault::formula,
          foucault::inputs,
          {{"alpha", "rad"}},
          {{0.8526, 67, 7.292115e-5, 9.81, 0.5, 0.0447, 0, 0, 3600}},
          foucault::first_route,
          by_product,
          foucault::second_route,
          [](const std::vector<double>& in, Precision digits) {
            return from_the_circles(in, foucault::by_extrapolation(in, digits));
          },
          "the first route, the remainders bounded",
          by_product};
}

}  // namespace oddity::truth
