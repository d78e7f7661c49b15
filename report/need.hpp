#pragma once

#include <limits>

namespace oddity {

/// What someone asks of a scene. An error of the observables in their unit, or relative to the largest of
/// them.
struct Need {
  double error;
  bool relative = false;
  double horizon = 10;          ///< s
  double frames_a_second = 60;  ///< a step divides the frame evenly, and every method is at every frame
  double budget = std::numeric_limits<double>::infinity();  ///< s a frame
};

}  // namespace oddity
