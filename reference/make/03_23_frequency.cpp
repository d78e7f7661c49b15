#include "reference/make/even_limit.hpp"

// A massless bar about the origin, a mass m at r, and at s a spring (c, ell) with its foot at (s, -h).
// m r^2 w^2 = V''(0) = c s^2, for any h, g and ell.
namespace oddity::truth {

namespace frequency_03_23 {

Numbers by_hand(const std::vector<double>& in, int) {
  return {Number(in[2]) / in[1] * sqrt(Number(in[3]) / in[0])};
}

Numbers by_differences(const std::vector<double>& in, Precision digits) {
  const Number m = in[0], r = in[1], s = in[2], c = in[3], h = in[4], g = in[5], ell = in[6];
  const auto V = [&](const Number& q) -> Number {
    const Number dx = s * cos(q) - s, dy = s * sin(q) + h, stretch = sqrt(dx * dx + dy * dy) - ell;
    return m * g * r * sin(q) + c * stretch * stretch / 2;
  };
  const Numbers curvature = even_limit(
      [&](const Number& step) -> Numbers { return {(V(step) - 2 * V(0) + V(-step)) / (step * step)}; },
      digits);
  return {sqrt(curvature[0] / (m * r * r))};
}

}  // namespace frequency_03_23

Truth truth_03_23_frequency() {
  using namespace frequency_03_23;
  return {"angular frequency of small oscillations of a bar on a spring",
          "w = (s/r) sqrt(c/m)",
          {"m", "r", "s", "c", "h", "g", "ell"},
          {{"w", "rad/s"}},
          {{1, 1, 0.5, 98.1, 0.8, 9.81, 1}, {2, 0.75, 0.5, 20, 0.5, 9.81, 1}, {1, 2, 1, 300, 1.25, 1.5, 3}},
          "the second derivative by hand",
          by_hand,
          "extrapolated second differences of the potential energy",
          by_differences,
          "the first route",
          by_hand};
}

}  // namespace oddity::truth
