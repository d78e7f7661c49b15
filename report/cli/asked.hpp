#pragma once

#include <string>
#include <vector>

#include "report/study/need.hpp"
#include "report/study/parallel.hpp"
#include "report/study/run.hpp"

/// What the command line's words mean. All throw BadInput, with what they may have meant instead.
namespace oddity {

/// By its number.
const Entry& entry_of(const std::string& exercise);
/// The exercises, each once; of those that have a motion when `scenes`. All of them when none is named.
std::vector<Task> tasks_of(const std::vector<std::string>& exercises, bool scenes = false);
/// The exercises by their numbers or by words of their titles. All of them when none is named.
std::vector<Task> tasks_about(const std::vector<std::string>& exercises);
/// The exercise with "name=value" for some of its parameters; the value may have a unit.
Task task_of(const std::string& exercise, const std::vector<std::string>& overrides);

/// A need as it is written; an empty text was not given. Either an error or digits.
struct AskedNeed {
  std::string error = {}, digits = {}, horizon = "10", frames_per_second = "60", budget = {}, bodies = "1";
  std::string restart_every = {};
  std::string criterion = "path", time_limit = {};
  std::vector<std::string> only = {}, exclude = {};
  std::string precision = "double";
  bool cheapest = false, one_step = false;
  bool measure = false;     ///< what earlier runs measured is measured anew
  bool as_engines = false;  ///< unless an error is asked for, 1 cm and 1 degree as `engines` has it
  bool enclosed = false;    ///< the truth's error is proved
  bool thorough = false;    ///< every method at every setting
  bool explain = false;     ///< what was tried, and where the time went
};
constexpr double most_frames = 1e6;  ///< that a need may ask for: an hour at 277 frames per second
/// For an exercise that has a motion, at the task's parameters.
Need need_of(const Task&, const AskedNeed&);

/// "2/7".
Shard shard_of(const std::string& text);

/// A chapter that has exercises.
int chapter_of(const std::string& chapter);

}  // namespace oddity
