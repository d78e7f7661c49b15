#include "report/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/bad_input.hpp"
#include "reference/text.hpp"
#include "report/parallel.hpp"
#include "report/tried.hpp"

namespace oddity {

namespace {

std::string close_in_words(const Scene& scene, const std::string& unit) {
  if (unit.starts_with("m") && scene.close == 0.01) return unit == "m" ? "1 cm" : "1 cm, 0.01 rad";
  if (std::abs(scene.close - std::acos(-1.0) / 180) < 1e-12) return "1 degree";
  return rounded(scene.close, 3) + (unit == "1" ? "" : " " + unit);
}

/// The models of a motion in the order of its ladder.
std::vector<std::string> models_of(const Quantity& motion) {
  std::vector<std::string> models;
  for (const Method& method : motion.methods)
    if (std::ranges::find(models, method.model) == models.end()) models.push_back(method.model);
  return models;
}

/// The cheapest setting of any of the model's algorithms that holds, by counted work.
std::optional<Tried> cheapest(const std::vector<Start>& start, const std::string& model, const Need& need) {
  std::optional<Tried> best;
  for (const Method& method : start.front().motion.methods) {
    if (method.model != model) continue;
    for (double setting : settings(method, need)) {
      const Tried tried = attempt(start, method, setting, need);
      if (tried.holds() && (!best || tried.evaluations_a_frame < best->evaluations_a_frame)) best = tried;
      if (tried.holds() || hopeless(tried)) break;
    }
  }
  return best;
}

LeastModel least_model(std::vector<Start>& start, const std::string& says, const Need& need) {
  Quantity& motion = start.front().motion;
  motion.need.allowed = need.error * (need.relative ? size_of(motion.reference.value) : 1);
  for (const std::string& model : models_of(motion))
    if (auto found = cheapest(start, model, need)) return {says, need, found};
  return {says, need, {}};
}

/// A parameter, and values of it between which a model may stop being enough.
struct Line {
  const Parameter* parameter;
  std::vector<double> values;
};

/// The scene's hard parameter over its values; then each that differs from start to start, from a sixteenth
/// of its value to four times it.
std::vector<Line> lines(const Task& task, const Scene& scene) {
  const auto declared = [&](std::string_view name) {
    return &*std::ranges::find(task.parameters.declared(), name, &Parameter::name);
  };
  std::vector<Line> all{{declared(scene.varied), scene.over}};
  for (std::string_view name : scene.starts) {
    Line line{declared(name), {}};
    for (double factor : {0.0625, 0.125, 0.25, 0.5, 1.0, 2.0, 4.0})
      if (const double value = factor * task.parameters[name];
          value != 0 && value >= line.parameter->least && value <= line.parameter->most)
        line.values.push_back(value);
    all.push_back(std::move(line));
  }
  return all;
}

/// A model's error at its best: the least of its algorithms', each at its finest setting.
double best_error(const Quantity& motion, const std::string& model) {
  double best = std::numeric_limits<double>::infinity();
  for (const Method& method : motion.methods)
    if (method.model == model)
      if (const double error = run(motion, method, method.knob.settings.back()).error; error < best)
        best = error;
  return best;
}

/// A scene's models beside each other over the ledger's horizon, one parameter moved.
class Along {
 public:
  Along(const Task& task, const Need& need, const Reference& truth, const Method& truest)
      : task_(task),
        scene_(*task.entry->exercise.scene),
        need_(need),
        truth_(truth),
        truest_(truest),
        lines_(lines(task, scene_)) {}

  /// Where the model stops or begins to be enough, on the first line on which it does.
  std::optional<BreakEven> break_even(const std::string& model) const {
    for (const Line& line : lines_)
      for (std::size_t i = 0; i + 1 < line.values.size(); ++i)
        if (auto found = between(model, *line.parameter, line.values[i], line.values[i + 1])) return found;
    return {};
  }

 private:
  std::optional<BreakEven> between(const std::string& model, const Parameter& p, double a, double b) const {
    if (enough(model, p, a) == enough(model, p, b)) return {};
    double holds = enough(model, p, a) ? a : b, fails = holds == a ? b : a;
    while (std::abs(fails - holds) > 1e-3 * std::abs(holds))
      (enough(model, p, (holds + fails) / 2) ? holds : fails) = (holds + fails) / 2;
    const BreakEven found{model, std::string(p.name),     std::string(p.unit),    holds,
                          fails, judged(model, p, holds), judged(model, p, fails)};
    const bool confirmed = found.error_holds <= scene_.close && !(found.error_fails <= scene_.close);
    return confirmed ? std::optional(found) : std::nullopt;
  }

  Quantity motion(const Parameter& p, double at, const Reference& truth) const {
    Parameters parameters = task_.parameters;
    parameters.set(p.name, at);
    return scene_.motion(parameters, {need_.horizon, 4, need_.frames_a_second}, truth);
  }

  /// With the truest method in place of the truth.
  bool enough(const std::string& model, const Parameter& p, double at) const {
    Quantity seen = motion(p, at, Reference::nothing());
    const Method* method = method_of(seen, truest_.model, truest_.algorithm);
    if (!method) return false;
    seen.reference.value = run(seen, *method, method->knob.settings.back()).answer.value;
    return best_error(seen, model) <= scene_.close;
  }
  double judged(const std::string& model, const Parameter& p, double at) const {
    return best_error(motion(p, at, truth_), model);
  }

  const Task& task_;
  const Scene& scene_;
  const Need& need_;
  const Reference& truth_;
  const Method& truest_;
  std::vector<Line> lines_;
};

/// The method that comes nearest to the reference at its finest setting.
const Method& truest_method(const Quantity& motion) {
  const auto error = [&](const Method& m) {
    const double e = run(motion, m, m.knob.settings.back()).error;
    return std::isnan(e) ? std::numeric_limits<double>::infinity() : e;
  };
  return *std::ranges::min_element(motion.methods, {}, error);
}

}  // namespace

std::optional<Ledger> ledger(const Task& task, const Reference& truth) {
  if (!task.entry->exercise.scene) return {};
  const Scene& scene = *task.entry->exercise.scene;
  const Need game{scene.close}, digits{1e-10, true};
  const Starts starts(task, game, truth);
  std::vector<Start> start{starts.asked()};
  const Quantity& motion = start.front().motion;
  Ledger ledger{motion.unit, {}, {}, {}};
  const Along along(task, game, truth, truest_method(motion));
  ledger.least.push_back(least_model(start, close_in_words(scene, motion.unit), game));
  ledger.least.push_back(least_model(start, "10 digits", digits));
  for (const std::string& model : models_of(motion))
    if (auto found = along.break_even(model))
      ledger.break_evens.push_back(*found);
    else if (!(best_error(motion, model) <= scene.close))
      ledger.never.push_back(model);
  return ledger;
}

Results with_ledgers(Results results, std::span<const Task> tasks, const Reference& truth,
                     const Progress& progress) {
  struct Page {
    const Task* task;
    ExerciseResult* result;
  };
  std::vector<Page> pages;
  for (std::size_t i = 0; i < tasks.size(); ++i)
    if (tasks[i].entry->exercise.scene) pages.push_back({&tasks[i], &results.exercises[i]});
  Tally tally(progress, "looking for the least models", pages.size());
  parallel_for_each(pages, [&](const Page& page) {
    page.result->ledger = ledger(*page.task, truth);
    tally.add();
  });
  return results;
}

}  // namespace oddity
