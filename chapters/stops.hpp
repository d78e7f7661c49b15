#pragma once

#include <algorithm>
#include <cmath>

#include "chapters/exercise.hpp"

namespace oddity {

/// For methods that keep their own time: advance(from, to) from one stop of the horizon to the next, until it
/// returns false, and look(t) at the times looked at.
template <class Advance, class Look>
void through_stops(const Horizon& horizon, const Advance& advance, const Look& look) {
  const auto times = horizon.times(), stops = horizon.stops();
  std::size_t next = 1;
  for (std::size_t i = 1; i < stops.size(); ++i) {
    if (!advance(stops[i - 1], stops[i])) return;
    if (next == times.size() || stops[i] != times[next]) continue;
    look(stops[i]);
    ++next;
  }
}

/// How many equal steps, none longer than `step` but by rounding, make up `span`.
inline double count_of_steps(double span, double step) {
  return std::max(1.0, std::ceil(span / step * (1 - 1e-12)));
}

}  // namespace oddity
