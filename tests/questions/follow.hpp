#pragma once

#include <span>
#include <vector>

#include "tests/questions/mechanics.hpp"

namespace questions {

/// Method for a motion: collocation at Gauss's points, with this many of them in a step.
struct Way {
  int points = 24;
  Real tolerance = 1;   ///< in units of the motion's own
  double seconds = 30;  ///< limit of CPU time
  bool rates = false;   ///< appends the rates of the observables
};

/// The motion's observables at these increasing times. Ends early if the steps become too short or the CPU
/// time is over.
std::vector<Values> follow(const Motion&, std::span<const double> times, const Way&);

/// Reference motion of the judge.
struct Truth {
  std::vector<Values> frames;
  std::vector<Real> uncertain;  ///< up to each frame: twice the difference of the two runs
};

/// By two runs, with different points and steps, as far as both get.
Truth truth_of(const Motion&, std::span<const double> times, double seconds = 30, bool rates = false);

/// Gauss's points in (0, 1) and their weights.
struct Gauss {
  std::vector<Real> at, weight;
  explicit Gauss(int points);
};

}  // namespace questions
