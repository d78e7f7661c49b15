#pragma once

#include <string>

#include "reference/bad_input.hpp"
#include "solvers/stop.hpp"

namespace oddity {

/// Returns the result of `work`. Throws OutOfTime if it takes more seconds; `shorter` names a way to be
/// faster: "a shorter horizon", or is empty.
template <class Work>
auto in_time(double seconds, const std::string& shorter, const Work& work) {
  const Stop stop(seconds);
  const Stoppable here(&stop);
  try {
    return work();
  } catch (const Stopped&) {
    throw OutOfTime("no answer within the time limit: ask for " +
                    (shorter.empty() ? "" : shorter + ", or for ") +
                    "a longer --time-limit (none: no limit)");
  }
}

}  // namespace oddity
