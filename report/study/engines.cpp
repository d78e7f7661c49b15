#include "report/study/engines.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/text.hpp"
#include "report/study/sibling_program.hpp"
#include "report/study/whole_in_json.hpp"

namespace oddity {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

void summarize(EngineSeries& series) {
  series.floor = std::numeric_limits<double>::infinity();
  std::vector<double> step, error;
  for (const EngineTrial& t : series.trials) {
    if (t.in_needs < series.floor) series.floor = t.in_needs;
    step.push_back(1.0 / t.steps_per_frame), error.push_back(t.in_needs);
  }
  series.law = asymptotic_law(step, error);
}

const EngineTrial* EngineSeries::first_enough() const {
  const EngineTrial* first = nullptr;
  for (auto t = trials.rbegin(); t != trials.rend() && t->outcome == Outcome::ok; ++t) first = &*t;
  return first;
}

namespace {

/// NaN is written as null.
ordered_json kept(double x) { return std::isfinite(x) ? ordered_json(x) : ordered_json(nullptr); }
double number(const ordered_json& json) { return json.is_null() ? not_a_number : json.get<double>(); }

ordered_json kept(const std::vector<double>& numbers) {
  ordered_json all = ordered_json::array();
  for (double x : numbers) all.push_back(kept(x));
  return all;
}
std::vector<double> numbers(const ordered_json& json) {
  std::vector<double> all;
  for (const auto& x : json) all.push_back(number(x));
  return all;
}

Outcome outcome_named(const std::string& name) {
  using enum Outcome;
  for (Outcome o : {ok, inaccurate, non_finite, stalled, raised})
    if (name_of(o) == name) return o;
  throw BadInput("there is no outcome '" + name + "'");
}

/// Seven digits are enough for a drawing.
std::vector<double> shortened(std::vector<double> path) {
  for (double& x : path)
    if (std::isfinite(x)) x = *parse_number(format_significant(x, 7));
  return path;
}

ordered_json kept(const EngineTrial& t) {
  return {{"steps_per_frame", t.steps_per_frame},
          {"outcome", name_of(t.outcome)},
          {"message", t.message},
          {"errors", kept(t.errors)},
          {"in_needs", kept(t.in_needs)},
          {"energy", kept(t.energy)},
          {"momentum", kept(t.momentum)},
          {"off_joint", kept(t.off_joint)},
          {"seconds_per_frame", kept(t.seconds_per_frame)},
          {"spread", kept(t.spread)},
          {"same_bits", t.same_bits},
          {"restored", t.restored},
          {"path", kept(shortened(t.path))}};
}
EngineTrial trial_from(const ordered_json& j) {
  return {whole<int>(j.at("steps_per_frame")),
          outcome_named(j.at("outcome")),
          j.at("message"),
          numbers(j.at("errors")),
          number(j.at("in_needs")),
          number(j.at("energy")),
          number(j.value("momentum", ordered_json())),  // not in the oldest files
          number(j.at("off_joint")),
          number(j.at("seconds_per_frame")),
          number(j.at("spread")),
          j.at("same_bits"),
          j.at("restored"),
          numbers(j.value("path", ordered_json::array()))};
}

ordered_json kept(const EngineSeries& s) {
  ordered_json trials = ordered_json::array();
  for (const EngineTrial& t : s.trials) trials.push_back(kept(t));
  return {{"engine", s.engine},
          {"version", s.version},
          {"precision", s.precision},
          {"variant", s.variant},
          {"says", s.says},
          {"defaults", s.defaults},
          {"webassembly", s.webassembly},
          {"stated_order", s.stated_order},
          {"lasting", s.lasting},
          {"friction", s.friction},
          {"cannot", s.cannot},
          {"trials", trials}};
}
EngineSeries series_from(const ordered_json& j) {
  EngineSeries s{
      j.at("engine"),         j.at("version"),         j.at("precision"),   j.at("variant"),
      j.at("says"),           j.at("defaults"),        j.at("webassembly"), whole<int>(j.at("stated_order")),
      j.value("lasting", ""), j.value("friction", ""), j.at("cannot")};
  for (const auto& t : j.at("trials")) s.trials.push_back(trial_from(t));
  summarize(s);
  return s;
}

/// None is infinite or negative; NaN is unknown, and allowed.
bool are_sizes(const std::vector<double>& numbers) {
  return std::ranges::none_of(numbers, [](double x) { return x < 0 || std::isinf(x); });
}

/// Trials go from coarse to fine. Without trials there must be a reason why the engine cannot have the scene.
void require_trials(const EngineSeries& s) {
  if (s.trials.empty() && s.cannot.empty())
    throw std::runtime_error(s.engine + ", " + s.variant + " has no trials and no reason for that");
  int before = 0;
  for (const EngineTrial& t : s.trials) {
    if (t.steps_per_frame <= before)
      throw std::runtime_error("the steps per frame of " + s.engine + ", " + s.variant + " do not go up");
    before = t.steps_per_frame;
    if (!are_sizes(t.errors) ||
        !are_sizes({t.in_needs, t.energy, t.momentum, t.off_joint, t.seconds_per_frame, t.spread}))
      throw std::runtime_error("an error or a time of " + s.engine + ", " + s.variant + " is below zero");
    if (!t.path.empty() && t.errors.empty())
      throw std::runtime_error("a path of " + s.engine + ", " + s.variant + " has no error");
    if (t.outcome == Outcome::ok && !(t.in_needs <= 1))
      throw std::runtime_error("a trial of " + s.engine + ", " + s.variant +
                               " is ok with an error above the need");
    if (t.outcome == Outcome::inaccurate && t.in_needs <= 1)
      throw std::runtime_error("a trial of " + s.engine + ", " + s.variant +
                               " is inaccurate with an error within the need");
  }
}

/// Whether the error in needs is the largest of the errors, each in its need, where all are known.
bool follows(double in_needs, const std::vector<double>& errors, const std::vector<double>& needs) {
  const bool known = !errors.empty() && !std::isnan(in_needs) &&
                     std::ranges::none_of(errors, [](double e) { return std::isnan(e); });
  double largest = 0;
  for (std::size_t i = 0; known && i < errors.size(); ++i) largest = std::max(largest, errors[i] / needs[i]);
  return !known || in_needs == largest;
}

/// Every error has its unit, and there are frames.
void require_sense(const EngineContest& c) {
  const auto fits = [&](const std::vector<double>& errors) {
    return errors.empty() || errors.size() == c.units.size();
  };
  const auto is_positive = [](double x) { return x > 0 && std::isfinite(x); };
  if (!is_positive(c.horizon) || !is_positive(c.frames_per_second) ||
      !(c.horizon * c.frames_per_second <= most_frames))
    throw std::runtime_error("the horizon or the rate of " + c.scene + " is none");
  bool all = c.needs.size() == c.units.size() && !c.units.empty() &&
             std::ranges::all_of(c.needs, is_positive) && (!c.least || fits(c.least->errors));
  for (const EngineSeries& s : c.series) {
    require_trials(s);
    for (const EngineTrial& t : s.trials) all = all && fits(t.errors);
  }
  if (!all)
    throw std::runtime_error("an error of " + c.scene + " without its unit, or a unit without its need");
  for (const EngineSeries& s : c.series)
    for (const EngineTrial& t : s.trials)
      if (!follows(t.in_needs, t.errors, c.needs))
        throw std::runtime_error("a trial of " + s.engine + ", " + s.variant +
                                 ": its errors and its error in needs contradict each other");
}

}  // namespace

void write(const std::vector<EngineContest>& contests, const fs::path& file) {
  ordered_json all = ordered_json::array();
  for (const EngineContest& c : contests) {
    ordered_json series = ordered_json::array();
    for (const EngineSeries& s : c.series) series.push_back(kept(s));
    all.push_back({{"scene", c.scene},
                   {"title", c.title},
                   {"units", c.units},
                   {"needs", c.needs},
                   {"horizon", c.horizon},
                   {"frames_per_second", c.frames_per_second},
                   {"differs", c.differs},
                   {"rubs", c.rubs},
                   {"series", series},
                   {"least", c.least ? ordered_json{{"says", c.least->says},
                                                    {"errors", kept(c.least->errors)},
                                                    {"seconds_per_frame", kept(c.least->seconds_per_frame)}}
                                     : ordered_json(nullptr)}});
  }
  write_whole(file, all.dump(1) + "\n");
}

std::vector<EngineContest> read_engines(const fs::path& file) {
  if (!std::filesystem::exists(file))
    throw BadInput("cannot read " + file.string() + "; '" + program_as_typed() + " engines' writes it");
  const std::string text = read_whole(file);
  try {
    std::vector<EngineContest> contests;
    ordered_json all = ordered_json::parse(text);
    show_controls(all);
    if (!all.is_array()) throw std::runtime_error("it is no list of scenes");
    for (const auto& j : all) {
      EngineContest c{j.at("scene"),
                      j.at("title"),
                      j.at("units"),
                      j.at("needs"),
                      j.at("horizon"),
                      j.at("frames_per_second"),
                      {},
                      {},
                      j.value("differs", ""),
                      j.value("rubs", false)};
      for (const auto& s : j.at("series")) c.series.push_back(series_from(s));
      if (const auto& least = j.at("least"); !least.is_null())
        c.least =
            Instead{least.at("says"), numbers(least.at("errors")), number(least.at("seconds_per_frame"))};
      require_sense(c);
      contests.push_back(std::move(c));
    }
    return contests;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw BadInput(file.string() + ": not written by '" + program_as_typed() +
                   " engines': " + without_exception_name(error.what()) + "; remove it, and '" +
                   program_as_typed() + " engines' writes it again");
  }
}

}  // namespace oddity
