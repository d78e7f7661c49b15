#include "report/cli/asked.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>

#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/quantity_text.hpp"
#include "reference/reference.hpp"
#include "reference/similar.hpp"
#include "reference/text.hpp"
#include "report/cli/words.hpp"
#include "report/pages/readable.hpp"
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

/// Whether a title, or what a parameter says, has a word that may have been meant. Beside others, short ones
/// mean nothing.
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

/// The one exercise whose number is most like this one, where there is one alone.
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
    throw BadInput(refusal + "; chapter " + std::to_string(number->chapter) +
                   " has none; 'oddity list' shows all");
  }
  std::vector<std::string> meant;
  const WordsIn asked = words_of(text);
  for (const Entry& entry : registry()) {
    const std::string number = to_string(entry.number);
    if (std::ranges::find(near, number) != near.end() || mentions(words_of_title(entry), asked))
      meant.push_back(with_title(entry));
  }
  throw BadInput(refusal + suggested(meant) + (meant.empty() ? "; " : " ") + "'oddity list' shows all");
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

/// The same, with what it is the value of before the complaint.
double value_of(const std::string& what, std::string_view text, std::string_view unit) {
  try {
    return in_unit(text, unit);
  } catch (const BadInput& error) {
    throw BadInput(what + ": " + error.what());
  }
}

double positive(const std::string& what, std::string_view text, std::string_view unit) {
  const double value = value_of(what, text, unit);
  if (!(value > 0 && std::isfinite(value)))
    throw BadInput(what + " must be positive and finite, and is " + std::string(text));
  return value;
}

int whole_of(const std::string& what, const std::string& text, int least, int most) {
  const auto value = parse_number(text);
  if (!value || *value != std::round(*value) || *value < least || *value > most)
    throw BadInput(what + " must be a whole number from " + std::to_string(least) + " to " +
                   std::to_string(most) + ", and is '" + text + "'");
  return static_cast<int>(*value);
}

bool is_in_unit(const std::string& text, std::string_view unit) {
  try {
    in_unit(text, unit);
    return true;
  } catch (const BadInput&) {
    return false;
  }
}

/// To six digits, no more than the number: what is asked for so is still allowed.
std::string rounded_down(double x) {
  const std::string nearest = format_significant(x, 6);
  if (parse_number(nearest).value_or(x) <= x) return nearest;
  const double last_digit = std::pow(10, std::floor(std::log10(x)) - 5);
  return format_significant(x - last_digit / 2, 6);
}

/// Why a word that is no "name=value" may stand there, and what would be right.
[[noreturn]] void refuse_assignment(const std::string& word) {
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

std::vector<std::string> words_between_commas(const std::string& text) {
  std::vector<std::string> words;
  std::istringstream in(text);
  for (std::string word; std::getline(in, word, ',');) words.push_back(word);
  return words;
}

/// The unit that a number is written with.
ShownUnit shown_unit(const std::string& text, std::string_view unit) {
  double number{};
  const auto end = std::from_chars(text.data(), text.data() + text.size(), number).ptr;
  std::string symbol(end, text.data() + text.size());
  symbol.erase(0, symbol.find_first_not_of(' '));
  return {symbol, in_unit("1" + symbol, unit)};
}

Quantity motion_of(const Entry& entry) {
  const Scene& scene = scene_of(entry);
  return motion(scene, Parameters(entry.exercise.parameters), {scene.horizon}, Reference::nothing());
}

/// What engines are judged by, in the motion's units: "1cm,1deg".
std::string errors_for_engines(const Entry& entry) {
  std::string errors;
  const Quantity seen = motion_of(entry);
  for (std::string_view unit : seen.units())
    errors += std::string(errors.empty() ? "" : ",") + (unit == "rad" ? "1deg" : "1cm");
  return errors;
}

/// "0.01" for every unit of the observables, or "1cm", "1cm,1deg", one for each.
void set_errors(Need& need, const Entry& entry, const std::string& text) {
  const Quantity seen = motion_of(entry);
  const auto units = seen.units();
  for (const std::string& one : words_between_commas(text)) {
    if (parse_number(one)) {
      if (!std::isnan(need.error))
        throw BadInput("--error: '" + text +
                       "' has two errors without a unit; each needs its own, such as 1cm,1deg");
      need.error = positive("--error", one, "");
      continue;
    }
    const auto fits =
        std::ranges::find_if(units, [&](std::string_view unit) { return is_in_unit(one, unit); });
    if (fits == units.end() && units.size() == 1) positive("--error", one, units.front());
    if (fits == units.end())
      throw BadInput("--error: '" + one + "' is no error of " + seen.name + ", whose observables are in " +
                     joined({units.begin(), units.end()}));
    if (!need.errors.emplace(*fits, positive("--error", one, *fits)).second)
      throw BadInput("--error: two errors in " + std::string(*fits));
    need.shown[std::string(*fits)] = shown_unit(one, *fits);
  }
  for (std::string_view unit : units)
    if (std::isnan(need.error) && !need.errors.contains(unit))
      throw BadInput("--error: the observables are in " + joined({units.begin(), units.end()}) +
                     ", and none is given in " + std::string(unit) +
                     ": add it after a comma, as in 1cm,1deg");
  if (std::isnan(need.error)) need.error = need.errors.begin()->second;
}

/// The place of a word among those that an option takes.
std::ptrdiff_t require_one_of(const std::string& option, const std::string& word,
                              const std::vector<std::string>& words) {
  const auto found = std::ranges::find(words, word);
  if (found == words.end())
    throw BadInput(option + " '" + word + "' is none of " + joined(words) + suggested(similar(word, words)));
  return found - words.begin();
}

/// The names of a scene's models and of their algorithms, each once.
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

/// The names, and their words, that may have been meant.
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

/// A word that no model and no algorithm has would leave nothing, or exclude nothing. What the catalog has
/// may be excluded anywhere.
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
  const std::vector<std::string> names{"path", "energy", "period", "bounded", "constraint"};
  return static_cast<Criterion>(require_one_of("--criterion", text, names));
}

/// What someone asks of the motion, its error or digits.
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
  if (neither && !as_engines)
    throw BadInput("choose needs --error or --digits, as in --error 0.01 or --digits 6");
  need.relative = !asked.digits.empty();
  need.error = std::numeric_limits<double>::quiet_NaN();
  if (need.relative)
    need.error = std::pow(10, -whole_of("--digits", asked.digits, 1, 15));
  else if (need.criterion == Criterion::path)
    set_errors(need, entry, as_engines ? errors_for_engines(entry) : asked.error);
  else
    need.error = positive("--error", asked.error, "");
}

}  // namespace

const Entry& entry_of(const std::string& exercise) {
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
    const WordsIn asked = exercise_number(text) ? WordsIn() : words_of(text);
    const auto about = numbers_of([&](const Entry& e) { return mentions(words_of_title(e), asked); });
    if (about.empty()) numbers.push_back(to_string(entry_of(text).number));
    std::ranges::copy(about, std::back_inserter(numbers));
  }
  return tasks_of(numbers);
}

Task task_of(const std::string& exercise, const std::vector<std::string>& overrides) {
  Task task(entry_of(exercise));
  std::set<std::string> given;
  for (const std::string& assignment : overrides) {
    const auto equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) refuse_assignment(assignment);
    const std::string name = assignment.substr(0, equals);
    const Parameter& p = parameter_of(task, name);
    if (!given.insert(name).second) throw BadInput("parameter " + name + " is given twice");
    task.parameters.set(
        name, value_of("parameter " + name, std::string_view(assignment).substr(equals + 1), p.unit));
  }
  return task;
}

Need need_of(const Task& task, const AskedNeed& asked) {
  const Entry& entry = *task.entry;
  const std::string time = std::string(scene_of(entry).axes.time);
  Need need{};
  set_accuracy(need, entry, asked);
  need.objective = asked.cheapest ? Objective::cheapest : Objective::simple;
  need.only = asked.only;
  need.exclude = asked.exclude;
  need.one_step = asked.one_step;
  need.thorough = asked.thorough;
  require_one_of("--precision", asked.precision, {"float", "double", "any"});
  require_known_words(task, asked);
  need.in_double = asked.precision != "float";
  need.in_float = asked.precision != "double";
  if (!asked.time_limit.empty()) need.time_limit = positive("--time-limit", asked.time_limit, "s");
  need.horizon = positive("--horizon", asked.horizon, time);
  need.frames_per_second = positive("--fps", asked.frames_per_second, "1/" + time);
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
  if (!asked.restart_every.empty())
    need.restart_every = positive("--restart-every", asked.restart_every, time);
  need.bodies = whole_of("--bodies", asked.bodies, 1, 1'000'000);
  if (!asked.budget.empty()) {
    if (const auto number = parse_number(asked.budget))
      throw BadInput(*number > 0
                         ? "--budget needs a unit, such as " + asked.budget + "us"
                         : "--budget must be positive, and have a unit, such as 5us, and is " + asked.budget);
    need.budget = positive("--budget", asked.budget, "s");
  }
  return need;
}

int chapter_of(const std::string& chapter) {
  const int number = whole_of("--chapter", chapter, 1, chapters().back().number);
  std::vector<std::string> with;
  for (const Chapter& c : chapters())
    if (!numbers_of([&](const Entry& e) { return e.number.chapter == c.number; }).empty())
      with.push_back(std::to_string(c.number));
  if (std::ranges::find(with, std::to_string(number)) == with.end())
    throw BadInput("chapter " + chapter + " has no exercises; those that have some are: " + joined(with));
  return number;
}

Shard shard_of(const std::string& text) {
  const auto slash = text.find('/');
  const auto number = parse_number(text.substr(0, slash)),
             of = slash == std::string::npos ? std::optional<double>() : parse_number(text.substr(slash + 1));
  constexpr double most = 1e9;
  if (!number || !of || *number < 1 || *of < *number || *of > most || *number != std::round(*number) ||
      *of != std::round(*of))
    throw BadInput("--shard is a part of the whole, such as 1/4 to 4/4, of at most a billion, and is '" +
                   text + "'");
  return {static_cast<std::size_t>(*number), static_cast<std::size_t>(*of)};
}

}  // namespace oddity
