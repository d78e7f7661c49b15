#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/study/frames.hpp"
#include "report/study/is_enough.hpp"
#include "report/study/need.hpp"
#include "report/study/parallel.hpp"
#include "report/study/run.hpp"

/// What the command line's words mean. All throw BadInput, with what they may have meant instead.
namespace oddity {

/// By its number.
const Entry& entry_of(const std::string& exercise);
/// The exercises, each once; of those that have a motion when `scenes`. All of them when none is named.
std::vector<Task> tasks_of(const std::vector<std::string>& exercises, bool scenes = false);
/// The exercises by their numbers or by what they are about. All of them when none is named.
std::vector<Task> tasks_about(const std::vector<std::string>& exercises);
/// The exercise with "name=value" for some of its parameters; the value may have a unit.
Task task_of(const std::string& exercise, const std::vector<std::string>& overrides);

/// Exercises and, of one alone, what is changed of it.
struct WithOverrides {
  std::vector<std::string> exercises, overrides;
};
/// "3.5", "a=1" apart.
WithOverrides with_overrides(const std::vector<std::string>& words);
/// Exercises that have a motion, one of them with other parameters; all of them when none is named.
std::vector<Task> scenes_of(const std::vector<std::string>& words);

/// A need as it is written; an empty text was not given. Either an error or digits.
struct AskedNeed {
  std::string error = {}, digits = {}, horizon = "10", frames_per_second = "60", budget = {}, bodies = "1";
  std::string restart_every = {}, starts = "6";
  std::string jitter = {}, drop = {}, trace = {}, longest_frame = {},
              frame_seed = {};                            ///< of frames that differ
  std::string kick = {};                                  ///< "t=1s,theta'=+2"
  std::string energy = {}, period = {}, constraint = {};  ///< the errors of criteria beside the first
  std::string criterion = "path", time_limit = "60s";     ///< or "none"
  bool criterion_is_given = false;                        ///< and not taken as usual
  bool horizon_is_given = false, rate_is_given = false;
  bool frames_are_given = false;  ///< of a chart: those above, or the horizon
  std::vector<std::string> only = {}, exclude = {};
  std::string says = {};                ///< why this error and horizon, where a problem's file asks for none
  std::string method = {}, model = {};  ///< what someone runs: "semi-implicit Euler@60Hz"
  std::string precision = "double";
  bool cheapest = false, one_step = false;
  bool lockstep = false;    ///< bits that are the same everywhere
  bool measure = false;     ///< what earlier runs measured is measured anew
  bool as_engines = false;  ///< unless an error is asked for, 1 cm and 1 degree as a game asks
  bool enclosed = false;    ///< the truth's error is proved
  bool thorough = false;    ///< every method at every setting
  bool explain = false;     ///< what was tried, and where the time went
};
/// The first option of an error or a criterion that is given; empty: none is.
std::string accuracy_option(const AskedNeed&);
/// Frames as they come, of a scene whose unit of time is this.
FramesAsked frames_of(const AskedNeed&, const std::string& time);
/// For an exercise that has a motion, at the task's parameters.
Need need_of(const Task&, const AskedNeed&);
/// What the command line does not say a problem's file does: the horizon, the frames and, of a path, the
/// error.
void ask_as_file(AskedNeed&, const Entry& of_file);
/// As tasks_of; where frames are given, scenes at these.
std::vector<Task> tasks_at_frames(const std::vector<std::string>& exercises, const AskedNeed&);

// The one grammar of numbers on the command line, by what option they are of. What it does not use of a text
// it refuses.

/// "30deg" in `unit`.
double value_of(const std::string& what, std::string_view text, std::string_view unit);
/// The same, positive and between these.
double between(const std::string& what, std::string_view text, std::string_view unit, double least,
               double most);
/// In digits alone.
int count_of(const std::string& what, const std::string& text, int least, int most);
/// "1cm,1deg": what is between commas, none of it empty.
std::vector<std::string> listed(const std::string& what, const std::string& text);
/// For an exercise that has a motion: the method that `asked` names, by whatever name.
MethodAsked method_of(const Task&, const AskedNeed& asked, const Need&);

/// s, of --time-limit; infinite for "none".
double time_limit_of(const std::string& text);

/// "2/7".
Shard shard_of(const std::string& text);

/// A chapter that has exercises.
int chapter_of(const std::string& chapter);

}  // namespace oddity
