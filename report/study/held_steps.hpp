#pragma once

#include <map>
#include <string>
#include <utility>

#include "report/study/frames.hpp"
#include "report/study/need.hpp"
#include "report/study/run.hpp"

namespace oddity {

/// Longest step at which each method of fixed step passes.
struct HeldSteps {
  std::string asked = {};  ///< in words; empty: nothing
  /// Longest step by model and algorithm, in the scene's unit of time; 0: no step tried passes. A method has
  /// no entry if it cannot be judged by the request.
  std::map<std::pair<std::string, std::string>, double> longest = {};
  std::string frames = {};   ///< as they come: "10 % dropped"; empty: all are of the same length
  double longest_frame = 1;  ///< in units of a usual one
  /// The longest usual frame up to which a step a frame is stable; 0: none. Multistep methods have no entry:
  /// each frame of another length makes them begin without their history, as another method.
  std::map<std::pair<std::string, std::string>, double> stable_at_frames = {};
};

/// Judges over the need's horizon at the end of every step, as `choose` does at every frame, and only from
/// the requested start. Throws BadInput if the motion lacks the requested quantity, or is not known well
/// enough.
HeldSteps held_steps(const Task&, const Need&, const Reference&, const Progress& = {});

/// Finds the longest usual frame that is stable if each frame, of whatever length, is one step. Up to it no
/// small disturbance grows that does not grow in the true motion, as in `measured_limit` for equal steps, and
/// no recurring pattern of frames excites a resonance.
void find_stable_at_frames(HeldSteps&, const Task&, const FramesAsked&, double horizon, const Progress& = {});

}  // namespace oddity
