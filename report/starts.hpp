#pragma once

#include <string>
#include <vector>

#include "chapters/random.hpp"
#include "reference/reference.hpp"
#include "report/need.hpp"
#include "report/run.hpp"

namespace oddity {

/// One start of a scene: its true motion, and every method with what was asked as the need.
struct Start {
  std::string says;  ///< "a = 0.5121, L = 0.9034"
  Quantity motion;
};

/// The starts of one choice: the one asked for, and others beside it, whose `starts` parameters are each up
/// to a tenth off.
class Starts {
 public:
  /// Throws BadInput when the task's exercise has no motion.
  Starts(const Task&, const Need&, const Reference&);

  /// The start asked for. Throws BadInput when no true motion is known there, or not as exactly as asked.
  Start asked() const;
  /// `count` starts drawn afresh, less those of which no true motion is known.
  std::vector<Start> beside(int count);

 private:
  Parameters draw();
  Start start(const Parameters&) const;
  const Scene& scene() const { return *task_.entry->exercise.scene; }

  const Task& task_;
  const Need& need_;
  const Reference& truth_;
  Random random_{7};
};

}  // namespace oddity
