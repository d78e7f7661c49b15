#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "chapters/numbers.hpp"

namespace oddity {

/// Whether a conserved quantity has changed only by the rounding of its terms.
inline bool is_rounding(double change, const Conserved<double>& at_start) {
  constexpr double roundings = 256 * std::numeric_limits<double>::epsilon();
  return change <= roundings * (std::abs(at_start.value) + at_start.moving);
}

/// Largest change of the conserved quantities since the start, each relative to the part that moves in it;
/// NaN if one is NaN.
inline double drift(std::span<const Conserved<double>> at_start, std::span<const Conserved<double>> now,
                    std::span<const double> moving) {
  double drift = 0;
  for (std::size_t k = 0; k < now.size(); ++k) {
    const double change = std::abs(now[k].value - at_start[k].value);
    if (std::isnan(change)) return change;
    if (!is_rounding(change, at_start[k])) drift = std::max(drift, change / moving[k]);
  }
  return drift;
}

}  // namespace oddity
