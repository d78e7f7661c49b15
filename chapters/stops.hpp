#pragma once

#include "chapters/exercise.hpp"
#include "solvers/stop.hpp"

namespace oddity {

/// Runs a method that keeps its own time: advance(from, to) from one of the horizon's times to the next, then
/// look(to), until advance returns false.
template <class Advance, class Look>
void through_times(const Horizon& horizon, const Advance& advance, const Look& look) {
  const auto times = horizon.times();
  for (std::size_t i = 1; i < times.size(); ++i) {
    check_stop_at_times();
    if (!advance(times[i - 1], times[i])) return;
    look(times[i]);
  }
}

}  // namespace oddity
