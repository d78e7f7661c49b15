#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace oddity::ode {

/// Number of equal steps from t0 to t1 that are no longer than `step`: the one count that every loop over
/// steps uses. Rounding of t0, t1 and `step` adds no step: frames of n steps have n, however late they are.
inline double steps_in(double t0, double t1, double step) {
  constexpr double roundings = 4 * std::numeric_limits<double>::epsilon();
  const double rounded_by = roundings * std::max(std::abs(t0), std::abs(t1));
  const double span = std::abs(t1 - t0) * (1 - 1e-12) - rounded_by;
  return std::max(1.0, std::ceil(span / step));
}

}  // namespace oddity::ode
