#pragma once

#include <optional>
#include <vector>

#include "chapters/exercise.hpp"

namespace oddity {

/// At each frame, the motion's largest error in needs up to there; nothing where the value is not comparable.
std::vector<double> errors_until(const Quantity& motion, const Value&);

/// How a small disturbance of a start grows.
struct Parting {
  std::vector<double> until;  ///< in needs, the largest up to each frame
  bool is_chaotic = false;

  /// The frame from which on the disturbed path is off by more than the needs; none where it never is.
  std::optional<std::size_t> lost_at() const;
  /// What an error comes to in the end that grows as the disturbance does, from where it was last within the
  /// needs: more than the motion's size, which bounds what is seen of it.
  double in_the_end(const std::vector<double>& error_until) const;
};

/// `beside` has the path, at the motion's frames, of a start that differs by this part of itself. Chaotic:
/// some time within the horizon neighbours separate by more than a thousand times while the time doubles,
/// where those of a regular motion separate as a low power of the time. Nothing where `beside` is not
/// comparable.
Parting parting_of(const Quantity& motion, const Value& beside, double difference);

}  // namespace oddity
