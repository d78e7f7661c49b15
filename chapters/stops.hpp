#pragma once

#include <algorithm>
#include <cmath>

#include "chapters/exercise.hpp"

namespace oddity {

/// For methods that keep their own time: advance(from, to) from one of the horizon's times to the next, until
/// it returns false, and look(t) at each.
template <class Advance, class Look>
void through_times(const Horizon& horizon, const Advance& advance, const Look& look) {
  const auto times = horizon.times();
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (!advance(times[i - 1], times[i])) return;
    look(times[i]);
  }
}

/// How many equal steps, none longer than `step` but by rounding, make up `span`.
inline double count_of_steps(double span, double step) {
  return std::max(1.0, std::ceil(span / step * (1 - 1e-12)));
}

}  // namespace oddity
