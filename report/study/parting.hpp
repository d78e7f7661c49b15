#pragma once

#include <optional>
#include <vector>

#include "chapters/exercise.hpp"

namespace oddity {

/// The motion's largest error in needs up to each frame; empty if the value is not comparable.
std::vector<double> errors_until(const Quantity& motion, const Value&);

/// Growth of a small disturbance of a start.
struct Parting {
  std::vector<double> until;  ///< in needs, the largest up to each frame
  bool is_chaotic = false;

  /// The first frame from which the disturbed path is off by more than the needs; empty if it never is.
  std::optional<std::size_t> lost_at() const;
  /// Final value of an error that grows as the disturbance does, from the last frame where it was within the
  /// needs. It may exceed the motion's size, which bounds the visible error.
  double in_the_end(const std::vector<double>& error_until) const;
};

/// `beside` is the path, at the motion's frames, of a start that differs by this relative difference.
/// Chaotic: within the horizon neighbours separate more than a thousandfold while the time doubles; in a
/// regular motion they separate as a low power of the time. Empty if `beside` is not comparable.
Parting parting_of(const Quantity& motion, const Value& beside, double difference);

}  // namespace oddity
