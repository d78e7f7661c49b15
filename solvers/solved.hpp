#pragma once

#include <limits>
#include <string>

namespace oddity {

/// How a solver came to its end. Only `reached` may carry a result to be trusted.
enum class Ending {
  reached,
  non_finite,
  stalled,
  raised,
  chattering,  ///< events without end while the time does not move
  grazing      ///< a guard touches zero: whether it crosses, the algorithm cannot tell
};

/// What every solver returns: a value, and how it was obtained.
template <class T>
struct Solved {
  T value{};
  long evaluations = 0;  ///< calls of the user's function, counted
  double error_estimate = std::numeric_limits<double>::quiet_NaN();  ///< the method's own; NaN: it has none
  double drift = 0;  ///< largest relative change of a conserved quantity that was watched; 0: none watched
  Ending ending = Ending::reached;
  std::string message = {};  ///< why, when the ending is not `reached`
  bool comes_back = false;   ///< what was watched drifts about its first value, to and fro

  bool reached() const { return ending == Ending::reached; }
};

}  // namespace oddity
