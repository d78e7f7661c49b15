#include "formula/gauss.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace oddity::formula {

namespace {

/// Newton's method on the Legendre polynomial, from Tricomi's estimate of its root.
std::array<std::array<double, 2>, 64> computed() {
  constexpr int n = 64;
  std::array<std::array<double, 2>, 64> rule{};
  for (int i = 0; i < n; ++i) {
    long double x = std::cos(std::numbers::pi_v<long double> * (i + 0.75L) / (n + 0.5L)), slope = 1;
    for (int steps = 0; steps < 8; ++steps) {
      long double before = 1, p = x;
      for (int k = 2; k <= n; ++k) {
        const long double higher = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = higher;
      }
      slope = n * (before - x * p) / (1 - x * x);
      x -= p / slope;
    }
    rule[static_cast<std::size_t>(i)] = {static_cast<double>(x),
                                         static_cast<double>(2 / ((1 - x * x) * slope * slope))};
  }
  return rule;
}

}  // namespace

const std::array<std::array<double, 2>, 64>& gauss_64() {
  static const auto rule = computed();
  return rule;
}

}  // namespace oddity::formula
