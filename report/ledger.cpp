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
  if (unit == "m" && scene.close == 0.01) return "1 cm";
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

/// A scene along its hard parameter, looked at over the ledger's horizon.
class Along {
 public:
  Along(const Task& task, const Need& need, const Reference& truth)
      : task_(task), scene_(*task.entry->exercise.scene), need_(need), truth_(truth) {}

  /// The first value at which a model that held no longer does, bracketed; nothing when that does not happen.
  /// `truest` is where the search takes the motion from; the bracket is judged by the reference.
  std::optional<BreakEven> break_even(const std::string& model, std::size_t truest) const {
    for (std::size_t i = 0; i + 1 < scene_.over.size(); ++i) {
      double holds = scene_.over[i], fails = scene_.over[i + 1];
      const auto enough = [&](double at) { return stood_in(model, truest, at) <= scene_.close; };
      if (!enough(holds) || enough(fails)) continue;
      while (std::abs(fails - holds) > 1e-3 * std::abs(holds))
        (enough((holds + fails) / 2) ? holds : fails) = (holds + fails) / 2;
      const BreakEven found{model, holds, fails, judged(model, holds), judged(model, fails)};
      if (found.error_holds <= scene_.close && !(found.error_fails <= scene_.close)) return found;
    }
    return {};
  }

 private:
  Quantity motion(double at, const Reference& truth) const {
    Parameters parameters = task_.parameters;
    parameters.set(scene_.varied, at);
    return scene_.motion(parameters, {need_.horizon, 4, need_.frames_a_second}, truth);
  }

  /// The model's error at its best: the least of its algorithms', each at its finest setting.
  static double best_error(const Quantity& motion, const std::string& model) {
    double best = std::numeric_limits<double>::infinity();
    for (const Method& method : motion.methods)
      if (method.model == model)
        if (const double error = run(motion, method, method.knob.settings.back()).error; error < best)
          best = error;
    return best;
  }

  double stood_in(const std::string& model, std::size_t truest, double at) const {
    Quantity seen = motion(at, Reference::nothing());
    const Method& method = seen.methods.at(truest);
    seen.reference.value = run(seen, method, method.knob.settings.back()).answer.value;
    return best_error(seen, model);
  }
  double judged(const std::string& model, double at) const { return best_error(motion(at, truth_), model); }

  const Task& task_;
  const Scene& scene_;
  const Need& need_;
  const Reference& truth_;
};

/// The method that comes nearest to the reference at its finest setting.
std::size_t truest_method(const Quantity& motion) {
  std::size_t truest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < motion.methods.size(); ++i)
    if (const double error = run(motion, motion.methods[i], motion.methods[i].knob.settings.back()).error;
        error < least) {
      least = error;
      truest = i;
    }
  return truest;
}

}  // namespace

std::optional<Ledger> ledger(const Task& task, const Reference& truth) {
  if (!task.entry->exercise.scene) return {};
  const Scene& scene = *task.entry->exercise.scene;
  const Need game{scene.close}, digits{1e-10, true};
  const Starts starts(task, game, truth);
  std::vector<Start> start{starts.asked()};
  const Quantity& motion = start.front().motion;
  const auto declared = std::ranges::find(task.parameters.declared(), scene.varied, &Parameter::name);
  Ledger ledger{motion.unit,
                std::string(scene.varied),
                std::string(declared->unit),
                scene.over.front(),
                scene.over.back(),
                {},
                {}};
  ledger.least.push_back(least_model(start, close_in_words(scene, motion.unit), game));
  ledger.least.push_back(least_model(start, "10 digits", digits));
  const Along along(task, game, truth);
  const std::size_t truest = truest_method(motion);
  for (const std::string& model : models_of(motion))
    if (auto found = along.break_even(model, truest)) ledger.break_evens.push_back(*found);
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
