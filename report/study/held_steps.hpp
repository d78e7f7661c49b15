#pragma once

#include <map>
#include <string>
#include <utility>

#include "report/study/need.hpp"
#include "report/study/run.hpp"

namespace oddity {

/// Up to which step each method of fixed step meets what is asked of a scene's motion.
struct HeldSteps {
  std::string asked = {};  ///< in words; empty: nothing was
  /// By model and algorithm: the longest step, in the scene's unit of time; 0: none that was tried. What does
  /// not show what is asked has none.
  std::map<std::pair<std::string, std::string>, double> longest = {};
};

/// Over the need's horizon, at the end of every step: each judged as `choose` judges at every frame, from the
/// start asked for alone. Throws BadInput where the motion has not what is asked for, or is not known so
/// well.
HeldSteps held_steps(const Task&, const Need&, const Reference&, const Progress& = {});

}  // namespace oddity
