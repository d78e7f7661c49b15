#pragma once

#include <limits>
#include <string>
#include <vector>

#include "report/starts.hpp"

namespace oddity {

/// A method at one setting, over several starts.
struct Tried {
  std::string model, algorithm, knob;
  double setting = 0;
  double error = 0;  ///< the largest over the starts it was chosen on, in units of what was asked
  Outcome outcome = Outcome::ok;
  std::string where = {};  ///< the start on which it ended so, unless ok
  double evaluations_a_frame = 0;
  double seconds_a_frame = 0;
  double unseen_error = std::numeric_limits<double>::quiet_NaN();  ///< over the starts it was not chosen on

  bool holds() const { return outcome == Outcome::ok; }
};

/// The settings at which a method is tried for a need, from cheap to dear: whole numbers of steps a frame,
/// tolerances by decades, or the method's own.
std::vector<double> settings(const Method&, const Need&);

/// The method at a setting over the starts: its worst error, the first end that is not ok, and its work on
/// the first start, whose trial goes to `first`. The times are not measured.
Tried attempt(const std::vector<Start>&, const Method&, double setting, const Need&, Trial* first = nullptr);

/// It is no use to try finer settings: the method cannot be run here, or its work is out of all proportion.
bool hopeless(const Tried&);

}  // namespace oddity
