#include "report/cli/asked.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>
#include <tuple>

#include "chapters/scene.hpp"
#include "problem/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/quantity_text.hpp"
#include "reference/reference.hpp"
#include "reference/similar.hpp"
#include "reference/text.hpp"
#include "report/cli/about.hpp"
#include "report/cli/words.hpp"
#include "report/study/criterion.hpp"
#include "report/study/frames.hpp"
#include "report/study/kicks.hpp"
#include "report/study/sibling_program.hpp"
#include "report/text/readable.hpp"
#include "solvers/ode/catalog.hpp"

namespace oddity {

namespace {

std::vector<std::string> numbers_of(const auto& is_one) {
  std::vector<std::string> numbers;
  for (const Entry& entry : registry())
    if (is_one(entry)) numbers.push_back(to_string(entry.number));
  return numbers;
}

using WordsIn = std::vector<std::string_view>;

/// The words of a text.
WordsIn words_of(std::string_view text) {
  WordsIn words;
  const auto in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (auto end = text.begin(); end != text.end();) {
    const auto begin = std::find_if(end, text.end(), in_word);
    end = std::find_if_not(begin, text.end(), in_word);
    if (end != begin) words.emplace_back(begin, end);
  }
  return words;
}

const WordsIn& words_of_title(const Entry& entry) {
  static const std::vector<WordsIn> titles = [] {
    std::vector<WordsIn> all;
    for (const Entry& one : registry()) all.push_back(words_of(one.exercise.title));
    return all;
  }();
  return titles[static_cast<std::size_t>(&entry - registry().data())];
}

/// Whether a title or a parameter's description contains a word that may have been meant. Ignores short words
/// if there are several.
bool mentions(const WordsIn& says, const WordsIn& asked) {
  const std::size_t too_short = asked.size() == 1 ? 2 : 3;
  for (const std::string_view word : asked)
    for (const std::string_view said : says)
      if (word.size() > too_short && nearly_same(word, said, static_cast<int>(word.size()) / 4)) return true;
  return false;
}

std::string suggested(const std::vector<std::string>& names) {
  return names.empty() ? "" : "; did you mean " + joined(names, " or ") + "?";
}

/// "3.5 (Pendulum from 30 degrees)".
std::string with_title(const Entry& entry) {
  return to_string(entry.number) + " (" + std::string(entry.exercise.title) + ")";
}

/// The exercise whose number is most like this one; empty if there are several.
std::string likely(const std::vector<std::string>& near) {
  if (near.size() != 1) return "";
  for (const Entry& entry : registry())
    if (to_string(entry.number) == near.front()) return suggested({with_title(entry)});
  return "";
}

[[noreturn]] void refuse_exercise(const std::string& text) {
  const std::string refusal = "no exercise '" + text + "'";
  const auto near = similar(text, numbers_of([](const Entry&) { return true; }));
  if (const auto number = exercise_number(text)) {
    const auto beside = numbers_of([&](const Entry& e) { return e.number.chapter == number->chapter; });
    if (!beside.empty())
      throw BadInput(refusal + "; chapter " + std::to_string(number->chapter) + " has " + joined(beside) +
                     likely(near));
    throw BadInput(refusal + "; chapter " + std::to_string(number->chapter) + " has none; '" +
                   program_as_typed() + " list' shows all");
  }
  std::vector<std::string> meant;
  const WordsIn asked = words_of(text);
  for (const Entry& entry : registry()) {
    const std::string number = to_string(entry.number);
    if (std::ranges::find(near, number) != near.end() || mentions(words_of_title(entry), asked))
      meant.push_back(with_title(entry));
  }
  throw BadInput(refusal + suggested(meant) + (meant.empty() ? "; " : " ") + "'" + program_as_typed() +
                 " list' shows all");
}

const Parameter& parameter_of(const Task& task, const std::string& name) {
  const auto declared = task.parameters.declared();
  const auto found = std::ranges::find(declared, name, &Parameter::name);
  if (found != declared.end()) return *found;
  std::vector<std::string> names, meant;
  for (const Parameter& p : declared) names.emplace_back(p.name);
  const auto near = similar(name, names);
  const WordsIn asked = words_of(name);
  for (const Parameter& p : declared)
    if (std::ranges::find(near, p.name) != near.end() || mentions(words_of(p.says), asked))
      meant.push_back(std::string(p.name) + " (" + readable(std::string(p.says)) + ")");
  throw BadInput("no parameter '" + name +
                 "'; the parameters are: " + (names.empty() ? "none" : joined(names)) + suggested(meant));
}

[[noreturn]] void refuse_assignment(const std::string& word);

/// Parameters that consist of the name and a coordinate or index: v0x, v0y, v0z for v0; a11, a12, ... for a.
/// Empty if the name itself is a parameter.
std::vector<std::string> components_of(const Task& task, const std::string& name) {
  std::vector<std::string> all;
  for (const Parameter& p : task.parameters.declared()) {
    if (p.name == name) return {};
    if (!p.name.starts_with(name) || p.name.size() == name.size()) continue;
    const std::string_view rest = p.name.substr(name.size());
    const bool coordinate = rest == "x" || rest == "y" || rest == "z";
    const bool index = rest.size() == 2 && rest.find_first_not_of("0123456789") == rest.npos;
    if (coordinate || index) all.emplace_back(p.name);
  }
  return all.size() > 1 ? all : std::vector<std::string>();
}

/// Splits v0=1,2,-1 into one assignment per component; otherwise returns the assignment itself.
std::vector<std::string> each_alone(const Task& task, const std::string& assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) refuse_assignment(assignment);
  const std::string name = assignment.substr(0, equals);
  const auto components = components_of(task, name);
  if (components.empty()) return {assignment};
  std::vector<std::string> all;
  std::string_view left = std::string_view(assignment).substr(equals + 1);
  for (bool more = true; more;) {
    const auto comma = left.find(',');
    more = comma != left.npos;
    const std::string at = all.size() < components.size() ? components[all.size()] : "";
    all.push_back(at + "=" + std::string(left.substr(0, comma)));
    if (more) left.remove_prefix(comma + 1);
  }
  if (all.size() != components.size())
    throw BadInput(name + " takes " + std::to_string(components.size()) + " numbers (" + joined(components) +
                   "), and " + std::to_string(all.size()) + (all.size() == 1 ? " is" : " are") + " given");
  return all;
}

bool is_in_unit(const std::string& text, std::string_view unit) {
  try {
    in_unit(text, unit);
    return true;
  } catch (const BadInput&) {
    return false;
  }
}

/// Rounded to six digits, and not above the number, so that it is still within the limit.
std::string rounded_down(double x) {
  const std::string nearest = format_significant(x, 6);
  if (parse_number(nearest).value_or(x) <= x) return nearest;
  const double last_digit = std::pow(10, std::floor(std::log10(x)) - 5);
  return format_significant(x - last_digit / 2, 6);
}

/// Throws with the reason why a word is no "name=value", and a correction.
[[noreturn]] void refuse_assignment(const std::string& word) {
  if (word.empty()) throw BadInput("an argument is empty; parameters are name=value, as in a=30deg");
  const std::string refusal = "'" + word + "' is not name=value";
  if (exercise_number(word)) throw BadInput(refusal + ", and one exercise is asked for at a time");
  for (std::string_view unit : {"m", "s", "kg", "rad", "N", "1/s", "m/s", "rad/s"})
    if (is_in_unit("1" + word, unit))
      throw BadInput(refusal + ": a unit follows its number without a blank, as in 1" + word);
  throw BadInput(refusal + ": write it without blanks, as in a=30deg");
}

const Scene& scene_of(const Entry& entry) {
  if (entry.exercise.scene) return *entry.exercise.scene;
  throw BadInput("exercise " + to_string(entry.number) + " has no motion; those that have one are: " +
                 joined(numbers_of([](const Entry& e) { return e.exercise.scene.has_value(); })));
}

/// The unit that a number is written with, or the quantity's own.
ShownUnit shown_unit(const std::string& text, std::string_view unit) {
  const std::string symbol = written(text).unit.empty() ? std::string(unit) : written(text).unit;
  return {symbol, in_unit("1" + symbol, unit)};
}

Quantity motion_of(const Entry& entry) {
  const Scene& scene = scene_of(entry);
  return motion(scene, Parameters(entry.exercise.parameters), {scene.horizon}, Reference::nothing());
}

/// A game's tolerances in the motion's units: "1cm,1deg".
std::string errors_for_engines(const Entry& entry) {
  std::string errors;
  const Quantity seen = motion_of(entry);
  for (std::string_view unit : seen.units())
    errors += std::string(errors.empty() ? "" : ",") +
              (unit == "rad" ? "1deg"
               : unit == "m" ? "1cm"
                             : format_shortest(game_error(unit)) + std::string(unit));
  return errors;
}

bool has_unit(const std::string& text) {
  try {
    return !written(text).unit.empty();
  } catch (const BadInput&) {
    return true;  // it is no number
  }
}

/// Hint if a comma may have been meant as a decimal point, as in "1,5deg".
std::string decimal_point_meant(const std::vector<std::string>& parts) {
  if (parts.size() != 2 || !parse_count(parts[0]) || parts[1].empty() ||
      std::isdigit(static_cast<unsigned char>(parts[1].front())) == 0)
    return "";
  return ". A number has a point, as in " + parts[0] + "." + parts[1];
}

/// A relative or path error. References have 24 digits, and above the upper bound it is no error.
double positive(const std::string& what, const std::string& text, std::string_view unit) {
  return between(what, text, unit, 1e-24, 1e12);
}

/// "0.01" for every unit of the observables, or "1cm", "1cm,1deg", with one for each; without a unit for pure
/// numbers.
void set_errors(Need& need, const Entry& entry, const std::string& text) {
  const Quantity seen = motion_of(entry);
  const auto units = seen.units();
  const std::string all_units = joined({units.begin(), units.end()});
  const std::vector<std::string> parts = listed("--error", text);
  if (parts.size() == 1 && !has_unit(text)) {
    need.error = positive("--error", text, "");
    return;
  }
  const auto is_pure = [](std::string_view unit) { return unit.empty() || unit == "1"; };
  for (const std::string& one : parts) {
    if (!has_unit(one) && std::ranges::none_of(units, is_pure))
      throw BadInput("--error: '" + one + "' in '" + text +
                     "' has no unit: give one number for all, or one with its unit for each of " + all_units +
                     decimal_point_meant(parts));
    const auto fits = std::ranges::find_if(
        units, [&](std::string_view unit) { return has_unit(one) ? is_in_unit(one, unit) : is_pure(unit); });
    if (fits == units.end() && units.size() == 1) positive("--error", one, units.front());
    if (fits == units.end())
      throw BadInput("--error: '" + one + "' is no error of " + seen.name + ", whose observables are in " +
                     all_units);
    if (!need.errors.emplace(*fits, positive("--error", one, *fits)).second)
      throw BadInput("--error: '" + text + "' has two errors in " + std::string(*fits));
    if (has_unit(one)) need.shown[std::string(*fits)] = shown_unit(one, *fits);
  }
  for (std::string_view unit : units)
    if (!need.errors.contains(unit))
      throw BadInput("--error: the observables are in " + all_units + ", and none is given in " +
                     std::string(unit) + ": add it after a comma, as in 1cm,1deg");
  need.error = need.errors.begin()->second;
}

/// Index of a word among those that an option accepts. Throws BadInput for any other word.
std::ptrdiff_t require_one_of(const std::string& option, const std::string& word,
                              const std::vector<std::string>& words) {
  const auto found = std::ranges::find(words, word);
  if (found == words.end())
    throw BadInput(option + " '" + word + "' is not one of " + joined(words) +
                   suggested(similar(word, words)));
  return found - words.begin();
}

/// Sets the errors of the criteria that are asked for next to the main one. Throws BadInput if one of them is
/// the main one.
void set_also(Need& need, const AskedNeed& asked) {
  const auto add = [&](Criterion criterion, const std::string& option, const std::string& text,
                       std::string_view unit) {
    if (text.empty()) return;
    if (need.criterion == criterion)
      throw BadInput(option + ": --criterion selects this measure already, and --error is its error");
    need.also[criterion] = positive(option, text, unit);
  };
  add(Criterion::energy, "--energy", asked.energy, "");
  add(Criterion::period, "--period", asked.period, "");
  add(Criterion::constraint, "--constraint", asked.constraint, "m");
  if (!asked.constraint.empty() && !need.shown.contains("m"))
    need.shown["m"] = shown_unit(asked.constraint, "m");
}

/// Names of a scene's models and of their algorithms, each once.
struct MethodNames {
  std::vector<std::string> models, algorithms;
};

MethodNames method_names(const Task& task) {
  const Scene& scene = scene_of(*task.entry);
  const Quantity seen = scene.motion(task.parameters, {scene.horizon}, Reference::nothing());
  MethodNames names;
  const auto add = [](std::vector<std::string>& to, const std::string& name) {
    if (std::ranges::find(to, name) == to.end()) to.push_back(name);
  };
  for (const Method& m : seen.methods) add(names.models, m.model), add(names.algorithms, m.algorithm);
  return names;
}

/// Names, and words of names, that may have been meant.
std::string similar_names(const std::string& word, const MethodNames& names) {
  std::vector<std::string> candidates;
  const auto add = [&](const std::string& text) {
    if (text.size() > 3 && std::ranges::find(candidates, text) == candidates.end())
      candidates.push_back(text);
  };
  for (const auto* some : {&names.models, &names.algorithms})
    for (const std::string& name : *some) {
      add(name);
      std::istringstream in(name);
      for (std::string one; in >> one;) add(one);
    }
  return did_you_mean(word, candidates);
}

bool is_in_one(const std::string& word, const std::vector<std::string>& names) {
  return std::ranges::any_of(names,
                             [&](const std::string& name) { return name.find(word) != std::string::npos; });
}

/// Refuses a word that no model or algorithm contains: it would leave nothing, or exclude nothing. Any
/// algorithm of the catalog may be excluded.
void require_known_words(const Task& task, const AskedNeed& asked) {
  if (asked.only.empty() && asked.exclude.empty()) return;
  const MethodNames names = method_names(task);
  const auto require = [&](const std::string& option, const std::vector<std::string>& words, bool anywhere) {
    for (const std::string& word : words) {
      const bool known = is_in_one(word, names.models) || is_in_one(word, names.algorithms) ||
                         std::string_view("in float").find(word) != std::string_view::npos ||
                         (anywhere && std::ranges::any_of(ode::catalog(), [&](const auto& algorithm) {
                            return algorithm.name.find(word) != std::string::npos;
                          }));
      if (known) continue;
      const std::string meant = similar_names(word, names);
      throw BadInput(option + ": no model and no algorithm of " + to_string(task.entry->number) + " has '" +
                     word + "' in its name" +
                     (meant.empty() ? "; the models are: " + joined(names.models, "; ") +
                                          "; the algorithms: " + joined(names.algorithms, "; ")
                                    : meant));
    }
  };
  require("--only", asked.only, false);
  require("--exclude", asked.exclude, true);
}

Criterion criterion_of(const std::string& text) {
  return static_cast<Criterion>(
      require_one_of("--criterion", text, {criterion_names.begin(), criterion_names.end()}));
}

/// Sets the criterion, and its error or digits.
void set_accuracy(Need& need, const Entry& entry, const AskedNeed& asked) {
  need.criterion = criterion_of(asked.criterion);
  if (need.criterion == Criterion::bounded) {
    if (!asked.error.empty() || !asked.digits.empty())
      throw BadInput("--criterion bounded takes no --error and no --digits");
    need.error = 1;
    return;
  }
  if (need.criterion == Criterion::constraint) {
    if (asked.error.empty()) throw BadInput("--criterion constraint needs --error, a length such as 1mm");
    need.error = positive("--error", asked.error, "m");
    need.shown["m"] = shown_unit(asked.error, "m");
    return;
  }
  const bool neither = asked.error.empty() && asked.digits.empty();
  const bool as_engines = neither && asked.as_engines && need.criterion == Criterion::path;
  if (neither && need.criterion != Criterion::path)
    throw BadInput("--criterion " + asked.criterion + " needs --error, a part such as 1%");
  if (neither && !as_engines)
    throw BadInput("choose needs --error or --digits, as in --error 0.01 or --digits 6");
  need.relative = !asked.digits.empty();
  need.error = std::numeric_limits<double>::quiet_NaN();
  if (need.relative)
    need.error = std::pow(10, -count_of("--digits", asked.digits, 1, 15));
  else if (need.criterion == Criterion::path)
    set_errors(need, entry, as_engines ? errors_for_engines(entry) : asked.error);
  else
    need.error = positive("--error", asked.error, "");
}

}  // namespace

const Entry& entry_of(const std::string& exercise) {
  if (problem::is_file(exercise)) return problem::entry_of_file(exercise);
  const auto number = exercise_number(exercise);
  for (const Entry& entry : registry())
    if (number == entry.number) return entry;
  refuse_exercise(exercise);
}

std::vector<Task> tasks_of(const std::vector<std::string>& exercises, bool scenes) {
  std::vector<Task> tasks;
  for (const std::string& exercise : exercises) {
    const Entry& entry = entry_of(exercise);
    if (scenes) scene_of(entry);
    if (std::ranges::find(tasks, &entry, &Task::entry) == tasks.end()) tasks.emplace_back(entry);
  }
  for (const Entry& entry : registry())
    if (exercises.empty() && (!scenes || entry.exercise.scene)) tasks.emplace_back(entry);
  return tasks;
}

std::vector<Task> tasks_about(const std::vector<std::string>& exercises) {
  std::vector<std::string> numbers;
  for (const std::string& text : exercises) {
    if (problem::is_file(text)) {
      numbers.push_back(text);
      continue;
    }
    const auto about = exercise_number(text) ? std::vector<const Entry*>() : exercises_about(text);
    if (about.empty()) {
      if (const std::string near = near_words(text); !near.empty())
        throw BadInput("no exercise is about '" + text + "'" + near + " '" + program_as_typed() +
                       " list' shows all");
      numbers.push_back(to_string(entry_of(text).number));
    }
    for (const Entry* entry : about) numbers.push_back(to_string(entry->number));
  }
  return tasks_of(numbers);
}

WithOverrides with_overrides(const std::vector<std::string>& words) {
  WithOverrides all;
  for (const std::string& word : words)
    (word.find('=') == word.npos ? all.exercises : all.overrides).push_back(word);
  if (!all.overrides.empty() && all.exercises.size() != 1)
    throw BadInput("'" + all.overrides.front() + "' is of one exercise, and " +
                   (all.exercises.empty() ? "none is" : std::to_string(all.exercises.size()) + " are") +
                   " named");
  return all;
}

std::vector<Task> scenes_of(const std::vector<std::string>& words) {
  const auto [exercises, overrides] = with_overrides(words);
  if (overrides.empty()) return tasks_of(exercises, true);
  scene_of(entry_of(exercises.front()));
  return {task_of(exercises.front(), overrides)};
}

Task task_of(const std::string& exercise, const std::vector<std::string>& overrides) {
  Task task(entry_of(exercise));
  std::set<std::string> given;
  const auto set = [&](const std::string& assignment) {
    const auto equals = assignment.find('=');
    const std::string name = assignment.substr(0, equals);
    const Parameter& p = parameter_of(task, name);
    if (!given.insert(name).second) throw BadInput("parameter " + name + " is given twice");
    task.parameters.set(
        name, value_of("parameter " + name, std::string_view(assignment).substr(equals + 1), p.unit));
  };
  for (const std::string& word : overrides)
    for (const std::string& assignment : each_alone(task, word)) set(assignment);
  return task;
}

std::string accuracy_option(const AskedNeed& asked) {
  return !asked.error.empty()                                    ? "--error"
         : asked.criterion != "path" || asked.criterion_is_given ? "--criterion"
         : !asked.energy.empty()                                 ? "--energy"
         : !asked.period.empty()                                 ? "--period"
         : !asked.constraint.empty()                             ? "--constraint"
                                                                 : "";
}

namespace {

/// Lengths of frames, one per line, in a unit or in the scene's unit of time.
std::vector<double> trace_of(const std::string& file, const std::string& time) {
  std::vector<double> lengths;
  std::istringstream lines(read_whole(file));
  std::size_t number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty() || line.front() == '#') continue;
    lengths.push_back(between(file + ":" + std::to_string(number), line, time, least_frame, most_frame));
  }
  if (lengths.empty()) throw BadInput(file + " has no frames: write one length per line, such as 16.7ms");
  return lengths;
}

}  // namespace

FramesAsked frames_of(const AskedNeed& asked, const std::string& time) {
  FramesAsked frames;
  if (!asked.jitter.empty()) frames.jitter = between("--jitter", asked.jitter, "", least_part, most_part);
  if (!asked.drop.empty()) frames.drop = between("--drop", asked.drop, "", least_part, most_part);
  if (!asked.longest_frame.empty())
    frames.longest = between("--max-frame", asked.longest_frame, time, least_frame, most_frame);
  if (!asked.trace.empty()) frames.trace = trace_of(asked.trace, time);
  if (!asked.frame_seed.empty()) frames.seed = count_of("--frame-seed", asked.frame_seed, 0, most_seed);
  if (!asked.frame_seed.empty() && frames.jitter == 0 && frames.drop == 0)
    throw BadInput("--frame-seed is of --jitter or --drop, and neither is asked for");
  return frames;
}

namespace {

/// Frames as they come, if they are asked for.
void set_frame_times(Need& need, const AskedNeed& asked, const std::string& time) {
  const FramesAsked frames = frames_of(asked, time);
  need.frame_times = frame_times(frames, need.frames_per_second, need.horizon, time);
  if (!need.frame_times) return;
  if (!frames.trace.empty())  // on average
    need.frames_per_second =
        *parse_number(format_significant(need.frames() / need.time_of(need.frames()), 4));
  if (need.bodies > 1) throw BadInput("frames of different lengths are judged for one body");
  for (const Criterion criterion : criteria_of(need))
    if (criterion == Criterion::period) throw BadInput("a period is judged at frames of one length");
}

void set_kicks(Need& need, const Entry& entry, const std::string& text) {
  if (need.bodies > 1) throw BadInput("a kick is judged for one body");
  if (!need.in_double) throw BadInput("a kick is judged in double: leave out --precision float");
  std::tie(need.kicks, need.kicked) = kicks_of(scene_of(entry), motion_of(entry), text, need.horizon);
  need.in_float = false;
}

}  // namespace

Need need_of(const Task& task, const AskedNeed& asked) {
  const Entry& entry = *task.entry;
  const std::string time = std::string(scene_of(entry).axes.time);
  Need need{};
  set_accuracy(need, entry, asked);
  set_also(need, asked);
  need.objective = asked.cheapest ? Objective::cheapest : Objective::simple;
  need.only = asked.only;
  need.exclude = asked.exclude;
  need.one_step = asked.one_step;
  need.lockstep = asked.lockstep;
  need.thorough = asked.thorough;
  require_one_of("--precision", asked.precision, {"float", "double", "any"});
  require_known_words(task, asked);
  need.in_double = asked.precision != "float";
  need.in_float = asked.precision != "double";
  need.time_limit = time_limit_of(asked.time_limit);
  need.horizon = between("--horizon", asked.horizon, time, 1e-12, 1e12);
  need.frames_per_second = between("--fps", asked.frames_per_second, "1/" + time, 1e-12, 1e12);
  const double frames = need.horizon * need.frames_per_second;
  if (frames < 1) throw BadInput("the horizon is shorter than a frame");
  if (frames > most_frames) {
    const bool fast = need.frames_per_second > 1000;
    throw BadInput("--horizon " + asked.horizon + " at --fps " + asked.frames_per_second + " asks for " +
                   format_significant(frames, 3) + " frames, of at most a million: " +
                   (fast ? "--fps may be " + rounded_down(most_frames / need.horizon) + " over that time"
                         : "--horizon may be " + rounded_down(most_frames / need.frames_per_second) + " " +
                               time + " at that rate"));
  }
  // A contact ends a step, and a frame has at most 512 steps. A horizon has at most a million frames.
  if (!asked.restart_every.empty())
    need.restart_every = between("--restart-every", asked.restart_every, time,
                                 1 / (512 * need.frames_per_second), most_frames / need.frames_per_second);
  need.bodies = count_of("--bodies", asked.bodies, 1, 1'000'000);
  need.starts = count_of("--starts", asked.starts, 1, 100);
  if (!asked.budget.empty()) {
    if (const auto number = parse_number(asked.budget))
      throw BadInput(*number > 0
                         ? "--budget needs a unit, such as " + asked.budget + "us"
                         : "--budget must be positive, and have a unit, such as 5us, and is " + asked.budget);
    need.budget = between("--budget", asked.budget, "s", 1e-12, 1e6);
  }
  set_frame_times(need, asked, time);
  if (!asked.kick.empty()) set_kicks(need, entry, asked.kick);
  return need;
}

void ask_as_file(AskedNeed& need, const Entry& of_file) {
  const problem::Asked asked = problem::asked_by(of_file);
  if (!need.horizon_is_given) need.horizon = asked.horizon;
  if (!need.rate_is_given) need.frames_per_second = asked.frames_per_second;
  const bool by_path = need.criterion == "path" && need.digits.empty() && !need.as_engines;
  const bool has_error = by_path && need.error.empty();
  if (has_error) need.error = asked.error;
  if (has_error && !asked.error_reason.empty())
    need.says = "an error of " + asked.error + ", " + asked.error_reason;
  if (!need.horizon_is_given && !asked.horizon_reason.empty())
    need.says += (need.says.empty() ? "" : "; ") + asked.horizon_reason;
}

std::vector<Task> tasks_at_frames(const std::vector<std::string>& exercises, const AskedNeed& asked) {
  if (!asked.frames_are_given) return tasks_of(exercises);
  std::vector<Task> tasks = tasks_of(exercises, true);
  for (Task& task : tasks) {
    AskedNeed of_frames = asked;
    of_frames.criterion = "bounded";  // needs no error
    const auto is_its_file = [&](const std::string& word) {
      return problem::is_file(word) && &entry_of(word) == task.entry;
    };
    if (std::ranges::any_of(exercises, is_its_file)) ask_as_file(of_frames, *task.entry);
    const Need need = need_of(task, of_frames);
    task.frames = horizon_of(need);
    task.kicks = need.kicks;
    task.frames_text = shown_rate(need, std::string(scene_of(*task.entry).axes.time));
  }
  return tasks;
}

namespace {

/// "60Hz", "16ms", "1/60": a step in the scene's unit of time.
double step_of(const std::string& text, const std::string& time) {
  const auto within = [&](const std::string& part, const std::string& unit) {
    try {
      return between("--method", part, unit, 1e-9, 1e9);
    } catch (const BadInput& error) {
      if (time == "s") throw;
      throw BadInput(std::string(error.what()) + "; the scene's time is in " + time + ": a step is @60/" +
                     time + " or @1/60");
    }
  };
  if (text.starts_with("1/")) {
    const std::string rate = text.substr(2);
    return 1 / within(rate, has_unit(rate) ? time : "");
  }
  if (text.empty() || !has_unit(text))
    throw BadInput("--method: a step needs its unit, as in @60Hz or @16ms, or is a part, as in @1/60");
  const std::string per_time = "1/" + time;
  return is_in_unit(text, per_time) ? 1 / within(text, per_time) : within(text, time);
}

}  // namespace

MethodAsked method_of(const Task& task, const AskedNeed& asked, const Need& need) {
  const auto at = asked.method.find('@');
  const std::string name = asked.method.substr(0, at);
  const Scene& scene = scene_of(*task.entry);
  const Quantity seen = motion(scene, task.parameters, Reference::nothing());
  const std::vector<std::string> meant = algorithms_meant(name, seen.methods);
  if (meant.empty()) {
    const MethodNames names = method_names(task);
    throw BadInput("--method: no model of " + to_string(task.entry->number) + " has '" + name +
                   "'; the algorithms here are: " + joined(names.algorithms, "; ") +
                   did_you_mean(name, names.algorithms));
  }
  MethodAsked method{meant.front(), asked.model};
  const Method& one = *std::ranges::find(seen.methods, method.algorithm, &Method::algorithm);
  const std::string setting = at == std::string::npos ? "" : asked.method.substr(at + 1);
  if (one.resolution.name == "step")
    method.setting =
        at == std::string::npos ? 1 / need.frames_per_second : step_of(setting, std::string(scene.axes.time));
  else if (one.resolution.name == "tolerance")
    method.setting = between("--method: the tolerance of " + method.algorithm, setting, "", 1e-16, 1);
  else if (at != std::string::npos)
    throw BadInput("--method: " + method.algorithm + " has no step and no tolerance");
  return method;
}

int chapter_of(const std::string& chapter) {
  const int number = count_of("--chapter", chapter, 1, chapters().back().number);
  std::vector<std::string> with;
  for (const Chapter& c : chapters())
    if (!numbers_of([&](const Entry& e) { return e.number.chapter == c.number; }).empty())
      with.push_back(std::to_string(c.number));
  if (std::ranges::find(with, std::to_string(number)) == with.end())
    throw BadInput("chapter " + chapter + " has no exercises; those that have some are: " + joined(with));
  return number;
}

double time_limit_of(const std::string& text) {
  return text == "none" ? std::numeric_limits<double>::infinity()
                        : between("--time-limit", text, "s", 1e-3, 1e6);
}

Shard shard_of(const std::string& text) {
  const auto slash = text.find('/');
  const auto number = parse_count(text.substr(0, slash)),
             of = slash == std::string::npos ? std::optional<int>() : parse_count(text.substr(slash + 1));
  constexpr int most = 1'000'000'000;
  if (!number || !of || *number < 1 || *of < *number || *of > most)
    throw BadInput("--shard is a part of the whole, such as 1/4 to 4/4, of at most a billion, and is '" +
                   text + "'");
  return {static_cast<std::size_t>(*number), static_cast<std::size_t>(*of)};
}

double value_of(const std::string& what, std::string_view text, std::string_view unit) {
  try {
    return in_unit(text, unit);
  } catch (const BadInput& error) {
    throw BadInput(what + ": " + error.what());
  }
}

double between(const std::string& what, std::string_view text, std::string_view unit, double least,
               double most) {
  const double value = value_of(what, text, unit);
  if (!(value > 0 && std::isfinite(value)))
    throw BadInput(what + " must be positive and finite, and is " + std::string(text));
  if (value < least || value > most)
    throw BadInput(what + " goes from " + format_significant(least, 4) + " to " +
                   format_significant(most, 4) + (unit.empty() ? "" : " " + std::string(unit)) + ", and is " +
                   std::string(text));
  return value;
}

int count_of(const std::string& what, const std::string& text, int least, int most) {
  const auto count = parse_count(text);
  if (!count || *count < least || *count > most)
    throw BadInput(what + " must be a whole number from " + std::to_string(least) + " to " +
                   std::to_string(most) + ", and is '" + text + "'" +
                   (!count && parse_number(text) ? ": write it in digits alone" : ""));
  return *count;
}

std::vector<std::string> listed(const std::string& what, const std::string& text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0, end = 0; end != text.npos; begin = end + 1) {
    end = text.find(',', begin);
    parts.push_back(text.substr(begin, end == text.npos ? end : end - begin));
    if (parts.back().empty())
      throw BadInput(what + ": '" + text + "' has nothing " +
                     (end == text.npos ? "behind its last comma" : "before a comma"));
  }
  return parts;
}

}  // namespace oddity
