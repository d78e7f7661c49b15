#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/study/frames.hpp"
#include "report/study/is_enough.hpp"
#include "report/study/need.hpp"
#include "report/study/parallel.hpp"
#include "report/study/run.hpp"

/// Parses the command line's words. All functions throw BadInput, with a suggestion.
namespace oddity {

/// The exercise of a number.
const Entry& entry_of(const std::string& exercise);
/// The exercises, each once; if `scenes`, they must have a motion. All if none is named.
std::vector<Task> tasks_of(const std::vector<std::string>& exercises, bool scenes = false);
/// The exercises by number or topic. All if none is named.
std::vector<Task> tasks_about(const std::vector<std::string>& exercises);
/// The exercise with "name=value" for some of its parameters; the value may have a unit.
Task task_of(const std::string& exercise, const std::vector<std::string>& overrides);

/// Exercises, and changed parameters if there is only one.
struct WithOverrides {
  std::vector<std::string> exercises, overrides;
};
/// Separates "3.5" from "a=1".
WithOverrides with_overrides(const std::vector<std::string>& words);
/// Exercises with a motion, one of them with other parameters; all if none is named.
std::vector<Task> scenes_of(const std::vector<std::string>& words);

/// A need as written; empty: not given. Either an error or digits.
struct AskedNeed {
  std::string error = {}, digits = {}, horizon = "10", frames_per_second = "60", budget = {}, bodies = "1";
  std::string restart_every = {}, starts = "6";
  std::string jitter = {}, drop = {}, trace = {}, longest_frame = {},
              frame_seed = {};                            ///< for random lengths
  std::string kick = {};                                  ///< "t=1s,theta'=+2"
  std::string energy = {}, period = {}, constraint = {};  ///< errors of additional criteria
  std::string criterion = "path", time_limit = "60s";     ///< or "none"
  bool criterion_is_given = false;                        ///< given, not the default
  bool horizon_is_given = false, rate_is_given = false;
  bool frames_are_given = false;  ///< for a chart: those above, or the horizon
  std::vector<std::string> only = {}, exclude = {};
  std::string says = {};                ///< reason for this error and horizon, if a problem's file gives none
  std::string method = {}, model = {};  ///< the user's method: "semi-implicit Euler@60Hz"
  std::string precision = "double";
  bool cheapest = false, one_step = false;
  bool lockstep = false;    ///< bits that are the same everywhere
  bool measure = false;     ///< measure again instead of using earlier prices
  bool as_engines = false;  ///< without a given error, use 1 cm and 1 degree as in a game
  bool enclosed = false;    ///< the reference's error is proved
  bool thorough = false;    ///< every method at every setting
  bool explain = false;     ///< list the trials, and the time spent
};
/// The first given option for an error or a criterion; empty: none.
std::string accuracy_option(const AskedNeed&);
/// Frames as they come, of a scene whose unit of time is this.
FramesAsked frames_of(const AskedNeed&, const std::string& time);
/// For an exercise that has a motion, at the task's parameters.
Need need_of(const Task&, const AskedNeed&);
/// Takes the horizon, the frames and, for a path, the error from a problem's file if the command line does
/// not give them.
void ask_as_file(AskedNeed&, const Entry& of_file);
/// As tasks_of, or scenes at the given frames.
std::vector<Task> tasks_at_frames(const std::vector<std::string>& exercises, const AskedNeed&);

// All numbers of the command line are parsed here, for the option named by `what`. Trailing text is refused.

/// "30deg" converted to `unit`.
double value_of(const std::string& what, std::string_view text, std::string_view unit);
/// As `value_of`, but positive and within these bounds.
double between(const std::string& what, std::string_view text, std::string_view unit, double least,
               double most);
/// A whole number in digits.
int count_of(const std::string& what, const std::string& text, int least, int most);
/// "1cm,1deg": the parts between commas, none of them empty.
std::vector<std::string> listed(const std::string& what, const std::string& text);
/// The method that `asked` names, by any of its names. The exercise must have a motion.
MethodAsked method_of(const Task&, const AskedNeed& asked, const Need&);

/// Time in s for --time-limit; infinite for "none".
double time_limit_of(const std::string& text);

/// "2/7".
Shard shard_of(const std::string& text);

/// The number of a chapter. Throws BadInput if it has no exercises.
int chapter_of(const std::string& chapter);

}  // namespace oddity
