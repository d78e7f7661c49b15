#include "report/study/cheapest_models.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>

#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/in_long_double.hpp"
#include "reference/text.hpp"
#include "report/study/candidate.hpp"
#include "report/study/choose.hpp"
#include "report/study/parallel.hpp"
#include "report/study/picker.hpp"
#include "solvers/ode/catalog.hpp"

namespace oddity {

namespace {

/// "1 cm", "1 degree", "1 cm, 1 degree".
std::string game_in_words(const Quantity& motion) {
  std::string words;
  for (std::string_view unit : motion.units())
    words += (words.empty() ? "" : ", ") + std::string(unit == "m"    ? "1 cm"
                                                       : unit == "AU" ? "1 degree of the Earth's orbit"
                                                                      : "1 degree");
  return words;
}

/// The models of a motion in the order of its ladder.
std::vector<std::string> models_of(const Quantity& motion) {
  std::vector<std::string> models;
  for (const Method& method : motion.methods)
    if (std::ranges::find(models, method.model) == models.end()) models.push_back(method.model);
  return models;
}

/// A parameter, and values of it between which a model may stop being enough.
struct Line {
  const Parameter* parameter;
  std::vector<double> values;
};

/// The scene's hard parameter over its values. Then each parameter that differs from start to start, from a
/// sixteenth of its value to four times it.
std::vector<Line> lines(const Task& task, const Scene& scene) {
  const auto declared = [&](std::string_view name) {
    return &*std::ranges::find(task.parameters.declared(), name, &Parameter::name);
  };
  std::vector<Line> all{{declared(scene.sweep_parameter), scene.sweep_values}};
  for (std::string_view name : scene.perturbed_parameters) {
    if (name == scene.sweep_parameter) continue;
    Line line{declared(name), {}};
    for (double factor : {0.0625, 0.125, 0.25, 0.5, 1.0, 2.0, 4.0})
      if (const double value = factor * task.parameters[name];
          value != 0 && value >= line.parameter->least && value <= line.parameter->most)
        line.values.push_back(value);
    all.push_back(std::move(line));
  }
  return all;
}

/// In needs: the largest difference between two settings of an algorithm that still counts as the model's own
/// motion.
constexpr double exact_enough = 0.01;

/// A model's motion at its algorithm's finest setting, and its distance from that at the next coarser one.
struct Solved {
  std::string algorithm = {};
  Value value = {};
  double change = std::numeric_limits<double>::infinity();  ///< in needs; none of a closed form
};

/// Empty if the algorithm does not reach the end.
std::optional<Solved> solved(const Quantity& motion, const Method& method) {
  const auto& settings = method.resolution.settings;
  const Answer fine = run(motion, method, settings.back()).answer;
  if (!fine.reached() || !finite(fine.value)) return {};
  if (settings.size() == 1) return Solved{method.algorithm, fine.value, 0};
  Solved found{method.algorithm, fine.value};
  const Answer coarser = run(motion, method, settings[settings.size() - 2]).answer;
  if (coarser.reached() && finite(coarser.value))
    found.change = motion.in_needs(motion.errors(coarser.value, fine.value));
  return found;
}

/// Ranks closed forms and Taylor series first, then by order: many digits in few steps.
int promise(const Method& method) {
  const auto all = ode::catalog();
  const auto entry = std::ranges::find(all, method.algorithm, &ode::CatalogEntry::name);
  constexpr int most = 100;
  return entry == all.end() || entry->name == "Taylor series" ? most : entry->order;
}

/// Its last digits would cost more work than those of all other methods together. True of low or adaptive
/// order.
bool is_of_low_order(const Method& method) { return promise(method) <= 4; }

/// The model's own motion, so that its error is the model's and not the algorithm's. Takes the first
/// algorithm that hardly changes, or has no setting; otherwise the one that changes least. Low order only if
/// no other gets through.
std::optional<Solved> solved_best(const Quantity& motion, const std::string& model) {
  std::vector<const Method*> methods;
  for (const Method& method : motion.methods)
    if (method.model == model) methods.push_back(&method);
  std::ranges::stable_sort(methods, std::greater(), [](const Method* m) { return promise(*m); });
  std::optional<Solved> best;
  for (const Method* method : methods) {
    if (best && is_of_low_order(*method)) continue;
    auto found = solved(motion, *method);
    if (found && (!best || found->change < best->change)) best = std::move(found);
    if (best && best->change <= 0.01 * exact_enough) break;
  }
  return best;
}

/// No finer step can pass: at its present rate the error stays above the need. The rate is at most two orders
/// above the algorithm's own; a faster fall means that steps have just become stable.
bool out_of_reach(const Candidate& before, const Candidate& now, const Method& method, double finest) {
  const auto all = ode::catalog();
  const auto entry = std::ranges::find(all, method.algorithm, &ode::CatalogEntry::name);
  if (now.resolution != "step" || entry == all.end() || !(now.error < before.error)) return false;
  const auto fallen = [&](double from, double to) { return std::pow(to / from, entry->order + 2); };
  return now.error > before.error * fallen(before.setting, now.setting) &&
         now.error * fallen(now.setting, finest) > 1;
}

/// The cheapest passing setting of any of the model's algorithms, by counted work.
std::optional<Candidate> cheapest(const std::vector<Start>& start, const std::string& model,
                                  const Need& need) {
  constexpr double no_games = 1e4;  // evaluations per frame, too many for a game
  std::optional<Candidate> best;
  for (const Method& method : start.front().motion.methods) {
    if (method.model != model) continue;
    const std::vector<double> all = settings(method, need);
    std::optional<Candidate> before;
    for (double setting : all) {
      const Candidate candidate = evaluate(start, method, setting, need);
      if (before && out_of_reach(*before, candidate, method, all.back())) break;
      before = candidate;
      if (candidate.holds() && (!best || candidate.evaluations_per_frame < best->evaluations_per_frame))
        best = candidate;
      const bool costs_more = best && candidate.evaluations_per_frame >= best->evaluations_per_frame;
      const bool too_dear = hopeless(candidate) || candidate.evaluations_per_frame > no_games;
      if (candidate.holds() || costs_more || too_dear) break;
    }
  }
  return best;
}

std::optional<Candidate> again_in_float(const std::vector<Start>& start, const Candidate& found,
                                        const Need& need) {
  const Method* single = method_of(start.front().motion, found.model, in_float(found.algorithm));
  if (!single) return {};
  return evaluate(start, *single, found.setting, need);
}

/// Leaves out models that their page shows to be wrong.
CheapestModel cheapest_model(std::vector<Start>& start, const Scene& scene, const std::string& says,
                             const Need& need) {
  Quantity& motion = start.front().motion;
  motion.needs = needs_of(need, motion);
  motion.need.allowed = *std::ranges::min_element(motion.needs);
  for (const std::string& model : models_of(motion)) {
    if (std::ranges::find(scene.faulted, model) != scene.faulted.end()) continue;
    if (auto found = cheapest(start, model, need))
      return {says, need, found, again_in_float(start, *found, need)};
  }
  return {says, need, {}};
}

/// The algorithms that solve a scene's models best at its defaults.
using Solvers = std::map<std::string, std::string>;

Solvers solvers_of(const Quantity& motion) {
  Solvers solvers;
  for (const std::string& model : models_of(motion))
    if (const auto best = solved_best(motion, model)) solvers[model] = best->algorithm;
  return solvers;
}

/// Uses the model's usual solver, or its best one where that is not exact enough.
std::optional<Solved> solved(const Quantity& motion, const std::string& model, const Solvers& solvers) {
  if (const auto solver = solvers.find(model); solver != solvers.end())
    if (const Method* method = method_of(motion, model, solver->second))
      if (auto found = solved(motion, *method); found && found->change <= exact_enough) return found;
  return solved_best(motion, model);
}

/// Values from a to b: geometric if they have one sign and span more than fourfold, otherwise evenly spaced.
std::vector<double> spaced(double a, double b, int count) {
  const bool in_proportion = a * b > 0 && (b / a > 4 || a / b > 4);
  std::vector<double> values;
  for (int i = 0; i <= count; ++i) {
    const double part = static_cast<double>(i) / count;
    values.push_back(i == 0          ? a
                     : i == count    ? b
                     : in_proportion ? a * std::pow(b / a, part)
                                     : a + (b - a) * part);
  }
  return values;
}

/// Compares a scene's models over the page's horizon while one parameter changes.
class Along {
 public:
  Along(const Task& task, const Need& need, const Reference& truth, std::string truest,
        const Solvers& solvers)
      : task_(task),
        scene_(*task.entry->exercise.scene),
        need_(need),
        truth_(truth),
        truest_(std::move(truest)),
        solvers_(solvers),
        lines_(lines(task, scene_)) {}

  /// Where the model is enough, for each line on which it is enough somewhere and fails somewhere.
  std::vector<BreakEven> break_evens(const std::string& model) const {
    std::vector<BreakEven> all;
    for (const Line& line : lines_)
      if (line.values.size() > 1)
        if (auto found = along(model, *line.parameter, line.values)) all.push_back(std::move(*found));
    return all;
  }

 private:
  struct Look {
    double at, error;  ///< in needs; infinite if the model has no motion; NaN if nothing solves this model,
                       ///< or the truest, exactly enough
    bool known() const { return !std::isnan(error); }
    bool enough() const { return error <= 1; }
  };

  struct Border {
    double holds, fails;  ///< the parameter on its two sides
    bool known;           ///< to one in a thousand
  };

  /// Looks through the values around the task's own between which the models' motions are known exactly
  /// enough. Looks at the values given, and then at equal parts, unless the model clearly passes or fails at
  /// all of them. Looks closer where the error comes near the need without crossing it. An island narrower
  /// than a thousandth of the range may be missed.
  std::optional<BreakEven> along(const std::string& model, const Parameter& p,
                                 const std::vector<double>& values) const {
    constexpr int parts = 48;
    constexpr double by_far = 20;
    std::vector<double> errors;
    for (double at : values)
      if (const Look one = look(model, p, at); one.known()) errors.push_back(one.error);
    if (errors.empty() || std::ranges::max(errors) < 1 / by_far || std::ranges::min(errors) > by_far)
      return {};
    const auto [first, last] = std::ranges::minmax(values);
    std::vector<Look> looks;
    for (double at : spaced(first, last, parts)) {
      const Look next = look(model, p, at);
      if (!next.known() && at < task_.parameters[p.name]) looks.clear();
      if (!next.known() && at > task_.parameters[p.name]) break;
      if (!next.known()) continue;
      if (!looks.empty()) refine(model, p, looks, next, 3);
      looks.push_back(next);
    }
    if (looks.size() < 2) return {};
    const double least = looks.front().at, most = looks.back().at;
    BreakEven found{model, std::string(p.name), std::string(p.unit), {least, most}, {}};
    std::vector<Border> borders;
    for (std::size_t i = 0; i < looks.size(); ++i) {
      if (looks[i].enough() && (i == 0 || !looks[i - 1].enough()))
        found.enough.push_back({i == 0 ? least : crossing(model, p, looks[i - 1], looks[i], borders), most});
      if (i > 0 && looks[i - 1].enough() && !looks[i].enough())
        found.enough.back().to = crossing(model, p, looks[i], looks[i - 1], borders);
    }
    if (borders.empty()) return {};  // enough everywhere, or nowhere
    found.coarse = !std::ranges::all_of(borders, &Border::known);
    for (const Border& border : borders)
      if (found.why.empty()) found.why = why_none(model, p, border.fails);
    found.holding.resize(borders.size());
    found.failing.resize(borders.size());
    in_parallel(2 * borders.size(), [&](std::size_t i) {  // a true motion takes a while
      const Border& border = borders[i / 2];
      (i % 2 == 0 ? found.holding : found.failing)[i / 2] =
          by_reference(model, p, i % 2 == 0 ? border.holds : border.fails);
    });
    return found;
  }

  /// Adds looks between the last one and the next where both are on one side and either is near the border.
  void refine(const std::string& model, const Parameter& p, std::vector<Look>& looks, const Look& next,
              int depth) const {
    constexpr double near_border = 1.5;
    const Look& last = looks.back();
    const double nearest = std::min(std::abs(std::log(last.error)), std::abs(std::log(next.error)));
    if (depth == 0 || last.enough() != next.enough() || !(nearest < std::log(near_border))) return;
    const Look middle = look(model, p, (last.at + next.at) / 2);
    if (!middle.known()) return;
    refine(model, p, looks, middle, depth - 1);
    looks.push_back(middle);
    refine(model, p, looks, next, depth - 1);
  }

  /// The value on the passing side, to one in a thousand, or as near as the motions are known. Adds both
  /// sides to the borders.
  double crossing(const std::string& model, const Parameter& p, Look fails, Look holds,
                  std::vector<Border>& borders) const {
    bool known = true;
    while (known && std::abs(fails.at - holds.at) > 1e-3 * std::abs(holds.at)) {
      const Look middle = look(model, p, (fails.at + holds.at) / 2);
      known = middle.known();
      if (known) (middle.enough() ? holds : fails) = middle;
    }
    borders.push_back({holds.at, fails.at, known});
    return holds.at;
  }

  Quantity motion(const Parameter& p, double at, const Reference& truth) const {
    Parameters parameters = task_.parameters;
    parameters.set(p.name, at);
    Quantity seen = oddity::motion(scene_, parameters, {need_.horizon, 1, need_.frames_per_second}, truth);
    seen.needs = needs_of(need_, seen);
    return seen;
  }

  double error(const std::string& model, const Quantity& seen) const {
    const auto found = solved(seen, model, solvers_);
    const double error = found ? seen.in_needs(seen.errors(found->value)) : std::nan("");
    if (std::isnan(error)) return std::numeric_limits<double>::infinity();
    return found->change <= exact_enough * std::max(1.0, error) ? error : std::nan("");
  }

  /// Why the model has no motion there; empty if it has one.
  std::string why_none(const std::string& model, const Parameter& p, double at) const {
    const Quantity seen = motion(p, at, Reference::nothing());
    if (solved(seen, model, solvers_)) return {};
    for (const Method& method : seen.methods)
      if (method.model == model)
        if (const Answer answer = run(seen, method, method.resolution.settings.back()).answer;
            !answer.message.empty() || !method.why.empty())
          return answer.message.empty() ? method.why : answer.message;
    return {};
  }

  /// NaN if the true motion would take more work than allowed.
  double by_reference(const std::string& model, const Parameter& p, double at) const {
    try {
      const Quantity seen = motion(p, at, truth_.to_digits(digits_in_long_double));
      return error(model, is_known_well(seen) ? seen : motion(p, at, truth_.to_digits(digits_for(need_))));
    } catch (const BadInput&) {
      return std::numeric_limits<double>::quiet_NaN();
    }
  }

  /// Takes the truest model as the reference.
  Look look(const std::string& model, const Parameter& p, double at) const {
    Quantity seen = motion(p, at, Reference::nothing());
    auto [known, is_new] = truths_.try_emplace({std::string(p.name), at});
    if (is_new) known->second = solved(seen, truest_, solvers_);
    if (!known->second || known->second->change > exact_enough) return {at, std::nan("")};
    seen.reference.value = known->second->value;
    return {at, error(model, seen)};
  }

  const Task& task_;
  const Scene& scene_;
  const Need& need_;
  Reference truth_;
  std::string truest_;
  const Solvers& solvers_;
  std::vector<Line> lines_;
  mutable std::map<std::pair<std::string, double>, std::optional<Solved>> truths_;
};

/// The model that, solved exactly, is nearest to the reference; of equals the last, which is the richest.
std::string truest_model(const Quantity& motion, const Solvers& solvers) {
  std::string truest;
  double least = std::numeric_limits<double>::infinity();
  for (const std::string& model : models_of(motion)) {
    const auto found = solved(motion, model, solvers);
    const double error = found ? motion.in_needs(motion.errors(found->value)) : std::nan("");
    if (error <= std::max(least, 1e-6)) {
      truest = model;
      least = std::min(error, least);
    }
  }
  return truest;
}

/// The simplest model that costs the same as the chosen one and is chosen if it is alone. `models` are from
/// the simplest to the richest.
CheapestModel recipe(const Task& task, const std::vector<std::string>& models, const std::string& says,
                     Need need, const Reference& truth) {
  need.objective = Objective::simple;
  const Choice choice = choose(task, need, truth, counted_price);
  CheapestModel recipe{says, need, choice.chosen};
  for (const std::string& model : models) {
    if (!choice.chosen || model == choice.chosen->model) break;
    if (std::ranges::find(choice.ties, model, &Candidate::model) == choice.ties.end()) continue;
    need.takes = [&](const std::string& other, const std::string&) { return other == model; };
    const Choice alone = choose(task, need, truth, counted_price);
    if (alone.chosen && alone.by_objective == choice.by_objective &&
        have_same_cost(*alone.chosen, *choice.chosen)) {
      recipe.least = alone.chosen;
      break;
    }
  }
  return recipe;
}

/// Evaluations of all trials.
double work(const ExerciseResult& result) {
  double evaluations = 0;
  for (const QuantityResult& quantity : result.quantities)
    for (const MethodResult& method : quantity.methods)
      for (const TimedTrial& trial : method.trials) evaluations += static_cast<double>(trial.evaluations);
  return evaluations;
}

}  // namespace

std::optional<CheapestModels> cheapest_models(const Task& task, const Reference& truth) {
  if (!task.entry->exercise.scene) return {};
  const Need game = game_need(), digits{1e-10, true};
  const InitialConditions starts(task, game, truth);
  std::vector<Start> start{starts.asked()};
  const Quantity motion = start.front().motion;
  CheapestModels cheapest_models;
  for (std::string_view unit : motion.units()) cheapest_models.units.emplace_back(unit);
  const Solvers solvers = solvers_of(motion);
  const Along along(task, game, truth, truest_model(motion, solvers), solvers);
  const std::string says = game_in_words(motion);
  cheapest_models.recipe = recipe(task, models_of(motion), says, game, truth);
  cheapest_models.least.push_back(cheapest_model(start, *task.entry->exercise.scene, says, game));
  cheapest_models.least.push_back(cheapest_model(start, *task.entry->exercise.scene, "10 digits", digits));
  for (const std::string& model : models_of(motion)) {
    auto found = along.break_evens(model);
    std::ranges::move(found, std::back_inserter(cheapest_models.break_evens));
    if (!found.empty()) continue;
    const auto by_model = solved(motion, model, solvers);
    if (!by_model || !(motion.in_needs(motion.errors(by_model->value)) <= 1))
      cheapest_models.never.push_back(model);
  }
  return cheapest_models;
}

Results with_cheapest_models(Results results, std::span<const Task> tasks, const Reference& truth,
                             const Progress& progress) {
  struct Page {
    const Task* task;
    ExerciseResult* result;
  };
  std::vector<Page> pages;
  for (std::size_t i = 0; i < tasks.size(); ++i)
    if (tasks[i].entry->exercise.scene) pages.push_back({&tasks[i], &results.exercises[i]});
  // Starts with the page that took the most work before.
  std::ranges::stable_sort(pages, std::greater(), [](const Page& page) { return work(*page.result); });
  Stage tally(progress, "looking for the least models", pages.size());
  parallel_for_each(pages, [&](const Page& page) {
    page.result->cheapest_models = cheapest_models(*page.task, truth);
    tally.add();
  });
  return results;
}

}  // namespace oddity
