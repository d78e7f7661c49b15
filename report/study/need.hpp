#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "chapters/kicks.hpp"

namespace oddity {

/// The quantity that has to be right.
enum class Criterion {
  path,        ///< the observables are within the error, at every frame
  energy,      ///< the energy is off its true value by at most the error, relative to its moving part
  period,      ///< the period is within the error, relative to it, and the swing as large as the true one
  bounded,     ///< nothing explodes, however wrong the path
  constraint,  ///< lengths and contacts are within the error of their constraints, at every frame
};

inline constexpr std::array criterion_names{"path", "energy", "period", "bounded", "constraint"};

/// Which of the passing methods is taken.
enum class Objective {
  simple,    ///< one-step with a fixed step, or a closed form, with a margin; then the cheapest
  cheapest,  ///< whatever is cheapest
};

/// A unit in which an error is asked for and shown: "cm", a hundredth of the motion's unit.
struct ShownUnit {
  std::string symbol;
  double size = 1;
};

inline constexpr double most_frames = 1e6;  ///< limit of a need: an hour at 277 frames per second

/// Frames of different lengths.
struct FrameTimes {
  std::vector<double> at;  ///< when each is drawn: ascending, after 0
  double longest = 0;
  std::string says = {};  ///< "each up to 20 % longer or shorter"
  std::string unit = {};  ///< unit of time
};

/// A request for a scene.
struct Need {
  double error;  ///< in each unit that `errors` does not name; relative: to the largest of the observables
  bool relative = false;
  double horizon = 10;            ///< s
  double frames_per_second = 60;  ///< a step divides the frame evenly; every method is judged at every frame
  std::shared_ptr<const FrameTimes> frame_times = {};       ///< null: all frames are of the same length
  std::shared_ptr<const Kicks> kicks = {};                  ///< null: none
  std::string kicked = {};                                  ///< "theta' + 2 rad/s at 1 s"
  double budget = std::numeric_limits<double>::infinity();  ///< s per frame
  long bodies = 1;                                          ///< identical ones, all in each frame
  double restart_every = std::numeric_limits<double>::infinity();  ///< s: contacts or changes end a run
  std::map<std::string, double, std::less<>> errors = {};          ///< by unit: {"m", 0.01}
  std::map<std::string, ShownUnit, std::less<>> shown = {};        ///< the requested units, by the motion's
  Criterion criterion = Criterion::path;
  std::map<Criterion, double> also = {};  ///< other criteria that have to pass as well, with their errors
  Objective objective = Objective::cheapest;
  std::vector<std::string> only = {}, exclude = {};  ///< words of models and algorithms
  /// Which of the models and algorithms named above may be taken; null: all.
  std::function<bool(const std::string& model, const std::string& algorithm)> takes = {};
  bool lockstep = false;  ///< a program whose bits are the same for every compiler and processor
  int starts = 6;         ///< on which it has to pass: the requested one, two next to it, others for the test
  bool one_step = false;  ///< no method that needs a history
  bool thorough = false;  ///< every method at every setting, against references of the most digits
  bool in_double = true, in_float = false;                      ///< the precisions that may be chosen
  double time_limit = std::numeric_limits<double>::infinity();  ///< s, for the answer

  double frames() const {
    if (!frame_times) return std::round(horizon * frames_per_second);
    return static_cast<double>(std::ranges::upper_bound(frame_times->at, horizon * (1 + 1e-12)) -
                               frame_times->at.begin());
  }
  /// Time of the `count`-th frame.
  double time_of(double count) const {
    return frame_times ? frame_times->at[static_cast<std::size_t>(count) - 1] : count / frames_per_second;
  }
  double error_in(std::string_view unit) const {
    const auto named = errors.find(unit);
    return named == errors.end() ? error : named->second;
  }
  /// The error by a requested criterion; of a path in needs.
  double error_by(Criterion c) const {
    return c != criterion ? also.at(c) : c == Criterion::path ? 1 : error;
  }
  /// Factor by which a method has to be better than requested on the starts that choose it.
  double margin() const { return objective == Objective::simple ? 3 : 1; }
};

}  // namespace oddity
