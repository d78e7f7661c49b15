#pragma once

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace oddity {

/// What has to hold.
enum class Criterion {
  path,        ///< the observables are within the error, at every frame
  energy,      ///< conserved quantities change by no more than the error, as a part of what moves in them
  period,      ///< the period is within the error, as a part of it
  bounded,     ///< nothing explodes, however wrong the path
  constraint,  ///< lengths that are held, and what lies on something, are within the error, at every frame
};

/// Which of those that hold is taken.
enum class Objective {
  simple,    ///< one-step with a fixed step, or a closed form, holding with a margin; then the cheapest
  cheapest,  ///< whatever is cheapest
};

/// A unit in which an error is asked for and shown: "cm", a hundredth of the motion's unit.
struct ShownUnit {
  std::string symbol;
  double size = 1;
};

/// What someone asks of a scene.
struct Need {
  double error;  ///< in each unit that `errors` does not name; relative: to the largest of the observables
  bool relative = false;
  double horizon = 10;            ///< s
  double frames_per_second = 60;  ///< a step divides the frame evenly, and every method is at every frame
  double budget = std::numeric_limits<double>::infinity();         ///< s per frame
  long bodies = 1;                                                 ///< alike, all of them in each frame
  double restart_every = std::numeric_limits<double>::infinity();  ///< s: contacts or changes end a run
  std::map<std::string, double, std::less<>> errors = {};          ///< by unit: {"m", 0.01}
  std::map<std::string, ShownUnit, std::less<>> shown = {};        ///< the units asked in, by the motion's
  Criterion criterion = Criterion::path;
  Objective objective = Objective::cheapest;
  std::vector<std::string> only = {}, exclude = {};  ///< words of models and algorithms
  bool one_step = false;                             ///< no method that needs a history
  bool thorough = false;  ///< every method at every setting, against truths of as many digits as there are
  bool in_double = true, in_float = false;                      ///< the precisions that may be chosen
  double time_limit = std::numeric_limits<double>::infinity();  ///< s, for the answer

  double frames() const { return std::round(horizon * frames_per_second); }
  double error_in(std::string_view unit) const {
    const auto named = errors.find(unit);
    return named == errors.end() ? error : named->second;
  }
  /// How many times better than asked a method has to be on the starts that it is chosen on.
  double margin() const { return objective == Objective::simple ? 3 : 1; }
};

}  // namespace oddity
