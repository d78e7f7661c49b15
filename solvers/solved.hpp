#pragma once

#include <limits>
#include <string>

namespace oddity {

/// How a solver ended. Trust a result only if it is `reached`.
enum class Ending {
  reached,
  non_finite,
  stalled,
  raised,
  chattering,  ///< events without end while the time does not move
  grazing      ///< a guard touches zero, and the algorithm cannot decide whether it crosses
};

/// Result of every solver: a value, and how it was obtained.
template <class T>
struct Solved {
  T value{};
  long evaluations = 0;                                              ///< calls of the user's function
  double error_estimate = std::numeric_limits<double>::quiet_NaN();  ///< the method's own; NaN: none
  double drift = 0;  ///< largest relative change of a watched conserved quantity; 0: none watched
  Ending ending = Ending::reached;
  std::string message = {};  ///< the reason, if the ending is not `reached`
  bool comes_back = false;   ///< the watched quantity drifts to and fro about its first value

  bool reached() const { return ending == Ending::reached; }
};

}  // namespace oddity
