#pragma once

#include <map>
#include <string>
#include <utility>

#include "report/study/need.hpp"
#include "report/study/run.hpp"

namespace oddity {

/// Longest step at which each method of fixed step passes.
struct HeldSteps {
  std::string asked = {};  ///< in words; empty: nothing
  /// Longest step by model and algorithm, in the scene's unit of time; 0: no step tried passes. A method has
  /// no entry if it cannot be judged by the request.
  std::map<std::pair<std::string, std::string>, double> longest = {};
};

/// Judges over the need's horizon at the end of every step, as `choose` does at every frame, and only from
/// the requested start. Throws BadInput if the motion lacks the requested quantity, or is not known well
/// enough.
HeldSteps held_steps(const Task&, const Need&, const Reference&, const Progress& = {});

}  // namespace oddity
