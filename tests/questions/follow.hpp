#pragma once

#include <span>
#include <vector>

#include "tests/questions/mechanics.hpp"

namespace questions {

/// How a motion is followed: collocation at Gauss's points, so many of them in a step.
struct Way {
  int points = 24;
  Real tolerance = 1;   ///< in units of the motion's own
  double seconds = 30;  ///< of processor, at most
  bool rates = false;   ///< of what is observed, after it
};

/// What the motion observes at these times, which rise. Ends early where the steps become too short or the
/// processor's time is over.
std::vector<Values> follow(const Motion&, std::span<const double> times, const Way&);

/// What is known of a motion.
struct Truth {
  std::vector<Values> frames;
  std::vector<Real> uncertain;  ///< up to each frame: twice what two ways part by
};

/// By two ways, with other points and steps, as far as both get.
Truth truth_of(const Motion&, std::span<const double> times, double seconds = 30, bool rates = false);

/// Gauss's points in (0, 1) and their weights.
struct Gauss {
  std::vector<Real> at, weight;
  explicit Gauss(int points);
};

}  // namespace questions
