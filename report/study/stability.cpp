#include "report/study/stability.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <span>

#include "chapters/scene.hpp"
#include "report/study/approve.hpp"
#include "report/study/every_step.hpp"
#include "report/study/failure.hpp"
#include "report/study/initial_conditions.hpp"
#include "report/study/limit_records.hpp"
#include "report/study/parallel.hpp"
#include "solvers/ode/known_tongues.hpp"
#include "solvers/ode/step_lengths.hpp"

namespace oddity {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The map's steps: the sample interval, halved repeatedly.
constexpr int map_steps = 12;

/// Limits that differ by less than this factor are the same.
constexpr double sharp = 1.05;

/// Ratio of successive steps in a scan.
constexpr double next_step = 1.03;

/// How long an observer watches motions, and which of the sizes counts as too large.
struct Observer {
  double time;
  std::size_t size;
};

/// The longest stable step and the shortest unstable one; 0: none.
struct Edge {
  double stable = 0, unstable = 0;
};

/// Runs each step once, for several observers of the same disturbances.
class Scan {
 public:
  Scan(const Disturbances& disturbances, double first, double finest, double longest)
      : disturbances_(disturbances), first_(first), finest_(finest), longest_(longest) {}

  /// The first loss of stability from below, to a relative accuracy of `part`; if it is where it is expected,
  /// without a scan and more coarsely.
  Edge edge(const Observer& observer, double part, std::optional<double> expected) {
    constexpr double coarse = 0.0065;
    if (expected)
      if (const auto found = confirmed(observer, coarse, *expected)) return *found;
    double low = first_;
    while (low > finest_ && lost(observer, low)) low = std::max(low / 4, finest_);
    if (lost(observer, low)) return {0, low};
    double high = low;
    while (high == low) {
      if (low >= longest_) return {low, 0};
      high = std::min(low * next_step, longest_);
      if (!lost(observer, high)) low = high;
    }
    return between(observer, low, high, part);
  }
  /// Whether this observer sees the loss after one step and by the other; 0: at the finest, infinity: at
  /// none.
  bool is_between(const Observer& observer, double stable, double unstable) {
    return (stable < finest_ || !lost(observer, std::min(stable, longest_))) &&
           (unstable > longest_ || lost(observer, std::max(unstable, finest_)));
  }
  double time(const Observer& observer, double step) { return loss(step).time(observer.size); }
  /// Whether the motion outgrows the true one before neighbours separate.
  bool outgrown(const Observer& observer, double step) {
    return loss(step).outgrown[observer.size] < loss(step).parted;
  }

 private:
  /// By a few steps. Zero: no step is stable; infinity: each one is.
  std::optional<Edge> confirmed(const Observer& observer, double part, double expected) {
    if (expected == 0 && lost(observer, finest_)) return Edge{0, finest_};
    if (std::isinf(expected)) {
      constexpr int tried = 8;
      for (int i = 0; i <= tried; ++i)
        if (lost(observer, first_ * std::pow(longest_ / first_, static_cast<double>(i) / tried))) return {};
      return Edge{longest_, 0};
    }
    constexpr double near = 0.003;  // expected steps have three digits
    const double below = expected * (1 - near), above = std::min(expected * (1 + near), longest_);
    if (below > finest_ && !lost(observer, below)) {
      if (lost(observer, above)) return between(observer, below, above, part);
      if (above == longest_) return Edge{longest_, 0};
    }
    constexpr double finely = 0.001;  // some losses are narrow
    const double last = std::min(expected * (1 + 6 * finely), longest_);
    for (double low = expected * (1 - 6 * finely); low < last; low *= 1 + finely) {
      const double high = std::min(low * (1 + finely), longest_);
      if (low > finest_ && !lost(observer, low) && lost(observer, high)) return Edge{low, high};
    }
    return {};
  }
  Edge between(const Observer& observer, double low, double high, double part) {
    while (high > (1 + part) * low) {
      const double middle = std::midpoint(low, high);
      (lost(observer, middle) ? high : low) = middle;
    }
    return {low, high};
  }
  bool lost(const Observer& observer, double step) { return time(observer, step) <= observer.time; }
  const ode::Loss& loss(double step) {
    const auto found = known_.find(step);
    return found != known_.end() ? found->second
                                 : known_.emplace(step, disturbances_.lost(step)).first->second;
  }

  const Disturbances& disturbances_;
  double first_, finest_, longest_;
  std::map<double, ode::Loss> known_;
};

/// Whether these observers see the limit where they are expected to, by a few steps. Without an approved
/// range all see it close to the usual edge. Otherwise one loses the range's least step, and one, perhaps the
/// usual, keeps its most.
bool is_confirmed(const std::string& soft, Scan& scan, std::span<const Observer> others, const Edge& usual) {
  constexpr double close = 1.024;  // close^2 < sharp
  const auto any = [&](double stable, double unstable) {
    return std::ranges::any_of(others,
                               [&](const Observer& o) { return scan.is_between(o, stable, unstable); });
  };
  if (soft.empty()) {
    // About the usual edge, narrower where a loss is narrow, and to its one side.
    constexpr double narrow = 1.01, least = 1.001, one_side = close * close / least;
    constexpr std::array<std::pair<double, double>, 4> windows{
        {{close, close}, {narrow, narrow}, {one_side, least}, {least, one_side}}};
    return std::ranges::any_of(windows, [&](const auto& window) {
      const double unstable = usual.unstable == 0 ? infinity : usual.unstable * window.second;
      return std::ranges::all_of(others, [&](const Observer& o) {
        return scan.is_between(o, usual.stable / window.first, unstable);
      });
    });
  }
  const auto range = soft_shown_as(soft);
  if (!range || !(range->most > sharp * range->least)) return false;
  const double near = range->least > 0 ? std::min(1.01, std::sqrt(range->most / (sharp * range->least))) : 1;
  const bool is_least =
      usual.unstable > 0 && usual.unstable<range->least * close, is_most = usual.stable> range->most / close;
  return (is_least || any(0, range->least * near)) && (is_most || any(range->most / near, infinity));
}

/// Measures the first loss of stability from below, and the range of this limit for observers who watch half
/// or twice as long, or count another size as too large. Each is looked for at the expected step first.
void measure(Limit& limit, const Disturbances& disturbances, double interval, const ApprovedLimit* expected) {
  constexpr double fewest_steps = 16, many_steps = 20'000, most_steps = 200'000;
  limit.watched = disturbances.span;
  limit.goes_on = disturbances.goes_on;
  limit.longest = std::min(interval, disturbances.span / fewest_steps);
  const double finest = std::max(ode::finest / disturbances.fastest, disturbances.span / most_steps);
  const double theory = limit.theory();
  // Starts well below theory's limit, or from many steps where theory is singular.
  const double below = theory < limit.longest ? theory / 4 : limit.longest / 50;
  const double first = std::min(std::max({below, disturbances.span / many_steps, finest}), limit.longest);
  Scan scan(disturbances, first, finest, limit.longest);
  // Distinguishes a limit from none only to a factor of two, as the mode varies.
  const auto told = [&](const Edge& edge) {
    return edge.unstable > 0 && edge.stable < 2 * finest ? 0 : edge.stable;
  };
  const Observer usual{disturbances.span, 1};
  const Edge edge = scan.edge(usual, 0.002, expected ? std::optional(expected->step) : std::nullopt);
  limit.stable = told(edge);
  limit.unstable = edge.unstable;
  if (edge.unstable > 0) {
    limit.lost = scan.time(usual, edge.unstable);
    limit.outgrown = scan.outgrown(usual, edge.unstable);
  }
  const std::array others{Observer{usual.time / 2, 1}, Observer{disturbances.watched, 1},
                          Observer{usual.time, 0}, Observer{usual.time, 2}};
  if (expected && is_confirmed(expected->soft, scan, others, edge)) {
    if (!expected->soft.empty()) limit.soft = soft_shown_as(expected->soft);
    return;
  }
  Between all{limit.stable, limit.stable};
  for (const Observer& other : others) {
    const double step = told(scan.edge(other, 0.005, expected ? std::optional(edge.stable) : std::nullopt));
    all = {std::min(all.least, step), std::max(all.most, step)};
  }
  if (all.most > sharp * all.least) limit.soft = all;
}

/// The motion by the longest step up to this one that divides the interval.
Trial run_at(const EveryStep& judge, const Method& method, double interval, double step) {
  return judge.judged(method, std::lround(std::ceil(interval / step * (1 - 1e-9)))).trial;
}

/// The motion by the shortest step from this one on that divides the interval, or by the interval.
Trial run_beyond(const Quantity& quantity, const Method& method, double interval, double step) {
  return run(quantity, method, interval / std::max(1.0, std::floor(interval / step * (1 + 1e-9))));
}

/// The cheaper of two ends, one of which may be missing.
void keep_cheaper(std::optional<TimedTrial>& best, const Trial& trial) {
  if (trial.outcome == Outcome::ok && (!best || trial.answer.evaluations < best->evaluations))
    best = as_result(trial);
}

/// Equal within a quarter.
bool agree(double a, double b) { return a == b || (a >= 0.8 * b && b >= 0.8 * a); }

/// Whether x is nearer to a than to b in ratio.
bool nearer(double x, double a, double b) { return std::abs(std::log(x / a)) < std::abs(std::log(x / b)); }

/// The first step, from half the shorter of the limits on, that loses a disturbance of the true motion when
/// the method steps only the disturbance. Infinity: none up to a quarter beyond the longer limit. By a scan;
/// or in brief by bisection between fewer steps, as if each longer step lost it as well.
double first_lost_along_truth(const Limit& limit, const Disturbances& disturbances, bool in_brief) {
  constexpr double most_steps = 20'000, coarse = 1.12;
  const double theory = std::min(limit.theory(), limit.longest);
  const double last = std::min(1.25 * std::max(limit.stable, theory), limit.longest);
  std::vector<double> steps;
  // In brief, a loss at the first step is as good as one before it: either is far from theory's limit.
  const double least = in_brief && limit.stable == 0 ? theory / 2 : std::min(limit.stable, theory) / 2;
  for (double step = std::max({least, ode::finest / disturbances.fastest, disturbances.span / most_steps});
       step <= last; step *= in_brief ? coarse : next_step)
    steps.push_back(step);
  const auto is_kept = [&](double step) { return disturbances.lost_along_truth(step) > disturbances.span; };
  const auto lost =
      in_brief ? std::ranges::partition_point(steps, is_kept) : std::ranges::find_if_not(steps, is_kept);
  return lost == steps.end() ? infinity : *lost;
}

/// Whether theory's growth, frozen at each point and summed along the true motion, stays below `granted` at
/// all steps up to the limit.
bool grows_at_most(double granted, const Limit& limit, const Disturbances& disturbances) {
  double most = -infinity;
  const double first = std::max(limit.theory(), ode::finest / disturbances.fastest);
  for (double part : {0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0})
    most = std::max(most, disturbances.added_growth(std::lerp(first, limit.stable, part)));
  return most <= std::log(granted);
}

/// The number of steps, from three to six, of one turn of the method's own motion, if it is near a whole
/// number.
std::optional<double> steps_of_a_turn(double turns_in_a_step) {
  constexpr double close = 0.02;
  const double steps = 1 / turns_in_a_step, whole = std::round(steps);
  if (whole < 3 || whole > 6 || std::abs(steps - whole) > close) return std::nullopt;
  return steps;
}

/// Computes why theory and measurement differ by more than a quarter. A third limit lies between them: along
/// the true motion, as in theory, but not frozen, as measured.
void explain(Limit& limit, const Disturbances& disturbances, const ode::Criteria& criteria, bool in_brief) {
  const double ratio = agreement(limit), theory = limit.theory();
  if (ratio >= 0.8 && ratio <= 1.25) return;
  const auto because = [&](const char* why, const std::string& evidence) {
    limit.why = why;
    limit.evidence = evidence;
  };
  const bool shorter = limit.step() < theory;
  if (shorter && limit.stable > 0 && (!limit.soft || limit.soft->most < 0.8 * theory))
    if (const auto steps = steps_of_a_turn(disturbances.turns_in_a_step(0.995 * limit.stable)))
      return because(
          "resonance: a turn of the method's motion takes a whole number of its steps, so that every turn makes the same error and the errors add up",
          format_significant(*steps, 3) + " steps a turn");
  if (limit.soft) return;  // its mark is the explanation
  limit.why = not_explained;
  const double along = first_lost_along_truth(limit, disturbances, in_brief);
  const std::string from = std::isinf(along) ? "no step tried is lost there"
                                             : "lost there from " + format_significant(along, 2) + " on";
  const bool frozen =
      shorter ? nearer(along, limit.stable, theory) && agree(along, limit.stable)
              : along >= limit.stable || (nearer(along, limit.stable, theory) && agree(along, limit.stable));
  if (frozen && !shorter && grows_at_most(criteria.granted, limit, disturbances))
    return because(
        "growth that theory finds at single points does not add up to a loss along the true motion", from);
  if (frozen)
    return because(
        "theory freezes the motion at each of its points; along the moving true motion, disturbances are lost at the measured step or later",
        from);
  if (shorter)
    if (const double own = disturbances.own_theory(limit.unstable, limit.lost); own < theory / 2)
      return because(
          "before the loss the method moves faster than the true motion; theory's limit along it is less than half",
          format_significant(own, 2));
  if (nearer(along, theory, limit.stable) && agree(along, theory))
    because(
        "theory is right for the true motion, along which disturbances are lost at its limit, but the method's motion is another",
        from);
}

double first_of(const std::vector<ode::Tongue>& tongues) {
  return tongues.empty() ? infinity : tongues.front().from;
}

/// A cure at the step that breaks the method: the cheapest other method that is within the need, of the same
/// model if there is one. If that step is too long for all, the cheapest with step control.
std::optional<TimedTrial> cure_of(const Quantity& quantity, const Limit& limit) {
  if (!limit.broken) return std::nullopt;
  std::optional<TimedTrial> same_model, other_model, controlled;
  for (const Method& method : quantity.methods)
    if (of_fixed_step(method))
      keep_cheaper(method.model == limit.model ? same_model : other_model,
                   run(quantity, method, limit.broken->setting));
  if (same_model) return same_model;
  if (other_model) return other_model;
  for (const Method& method : quantity.methods)
    if (method.resolution.name == "tolerance")
      for (double tolerance : method.resolution.settings)
        keep_cheaper(controlled, run(quantity, method, tolerance));
  return controlled;
}

/// A scene's motion at one set of parameters, for the map or the limits.
struct Motion {
  std::size_t place;  ///< index in the results
  Quantity quantity;
  double interval;
  double value = 0;  ///< value of the varied parameter
  bool varied = false;
  std::vector<Quantity> beside = {};            ///< if varied: from starts that are a few roundings off
  std::shared_ptr<const EveryStep> judge = {};  ///< unless varied
};

/// The perturbed parameters and the varied one, each so many roundings off and in its range.
Parameters moved(Parameters parameters, const Scene& scene, int roundings) {
  for (const Parameter& p : parameters.declared())
    if (p.name == scene.sweep_parameter || std::ranges::count(scene.perturbed_parameters, p.name) > 0) {
      constexpr double rounding = std::numeric_limits<double>::epsilon();
      if (!p.whole)
        parameters.set(p.name, std::clamp(parameters[p.name] * (1 + roundings * rounding), p.least, p.most));
    }
  return parameters;
}

/// The motion from starts that differ by a few roundings, judged by the same reference.
std::vector<Quantity> nearby_motions(const Quantity& quantity, const Scene& scene,
                                     const Parameters& parameters, double end) {
  std::vector<Quantity> all;
  for (int roundings : {-16, -4, -1, 1, 4, 16}) {
    all.push_back(motion(scene, moved(parameters, scene, roundings), {end}, Reference::nothing()));
    all.back().reference = quantity.reference;
    all.back().need = quantity.need;
    all.back().needs = quantity.needs;
  }
  return all;
}

Motion motion_of(const Task& task, std::size_t place, const Reference& truth, std::optional<double> value,
                 std::optional<double> asked_horizon = {}) {
  const Scene& scene = *task.entry->exercise.scene;
  Parameters parameters = task.parameters;
  if (value) parameters.set(scene.sweep_parameter, *value);
  const double end = asked_horizon.value_or(scene.horizon);
  Motion motion{place, oddity::motion(scene, parameters, {end}, truth), 0, value.value_or(0),
                value.has_value()};
  motion.interval = end / motion.quantity.samples;
  motion.quantity.need = {scene.game_tolerance, "a game's tolerance"};
  for (std::string_view unit : motion.quantity.units()) motion.quantity.needs.push_back(game_error(unit));
  if (value)
    motion.beside = nearby_motions(motion.quantity, scene, parameters, end);
  else
    motion.judge =
        std::make_shared<EveryStep>(motion.quantity, end, [&scene, parameters](const Horizon& horizon) {
          return oddity::motion(scene, parameters, horizon, Reference::nothing());
        });
  return motion;
}

std::string unit_of(const Task& task, std::string_view parameter) {
  for (const Parameter& p : task.parameters.declared())
    if (p.name == parameter) return std::string(p.unit);
  throw std::logic_error(to_string(task.entry->number) + " has no parameter " + std::string(parameter));
}

/// The scene's stability without its limits and map.
Stability shape(const Task& task, std::optional<double> horizon) {
  const Scene& scene = *task.entry->exercise.scene;
  Stability stability;
  stability.time_unit = scene.axes.time;
  stability.horizon = horizon.value_or(scene.horizon);
  stability.close = scene.game_tolerance;
  stability.parameter = scene.sweep_parameter;
  stability.parameter_unit = unit_of(task, scene.sweep_parameter);
  return stability;
}

/// One method of one motion: a limit or a row of the map.
struct Piece {
  const Motion* motion;
  const Method* method;
  bool on_record = false;  ///< a run that confirms records
  const ApprovedLimit* expected = nullptr;
  Limit limit = {};
  MapRow row = {};
  std::string failure = {};  ///< an exception that ended it; empty: none
};

/// Whether the predicate is true of the outcome from any of the starts a few roundings off.
bool any_nearby(const Motion& motion, const Method& method, int k,
                const std::function<bool(Outcome)>& holds) {
  return std::ranges::any_of(motion.beside, [&](const Quantity& beside) {
    const Method* same = method_of(beside, method.model, method.algorithm);
    return same && holds(run(beside, *same, std::ldexp(motion.interval, -k)).outcome);
  });
}

/// Whether roundings decide the method's outcome at the map's k-th step. Never so well within the need.
bool is_fragile(const Motion& motion, const Method& method, int k, const Trial& trial) {
  if (trial.outcome == Outcome::ok && trial.in_needs < 0.5) return false;
  return any_nearby(motion, method, k, [&](Outcome beside) { return beside != trial.outcome; });
}

/// Its outcomes; unless they are to be compared with records, also theory's limit and the fragile outcomes.
MapRow row_of(const Motion& motion, const Method& method, bool on_record) {
  MapRow row{method.model, method.algorithm, motion.value, infinity, {}, {}};
  if (!on_record) row.theory = first_of(method.unstable_steps());
  for (int k = 0; k < map_steps; ++k) {
    const Trial trial = run(motion.quantity, method, std::ldexp(motion.interval, -k));
    row.outcomes.push_back(trial.outcome);
    row.fragile.push_back(!on_record && is_fragile(motion, method, k, trial));
  }
  return row;
}

std::vector<ode::Tongue> unstable_steps(const Method& method, const ApprovedLimit* expected) {
  constexpr std::size_t few = 8;  // more are scanned as fast as confirmed
  const auto known = expected ? tongues_shown_as(expected->unstable) : std::nullopt;
  if (!known || known->size() > few) return method.unstable_steps();
  const ode::KnownTongues here(*known);
  return method.unstable_steps();
}

/// The expected limit by a few steps, where they confirm it.
Limit measured(const Method& method, double interval, const ode::Criteria& criteria,
               const ApprovedLimit* expected) {
  Limit limit;
  limit.model = method.model;
  limit.algorithm = method.algorithm;
  limit.tongues = unstable_steps(method, expected);
  const Disturbances disturbances = method.disturbances(criteria);
  measure(limit, disturbances, interval, expected);
  if (ode::StepLengths::here()) return limit;
  explain(limit, disturbances, criteria, expected != nullptr);
  return limit;
}

/// The expected step within the need, or none, where a few steps confirm it.
std::optional<TimedTrial> largest_within_need(const EveryStep& judge, const Quantity& quantity,
                                              const Method& method, double interval,
                                              const ApprovedLimit* expected) {
  if (expected && !expected->needed && is_never_within_need(judge, method, quantity.samples)) return {};
  if (expected && expected->needed)
    if (auto found = confirmed_within_need(judge, method, quantity.samples, interval / *expected->needed))
      return found;
  return within_need(judge, method, quantity.samples);
}

/// A limit with its trials.
Limit limit_by(const EveryStep& judge, const Quantity& quantity, const Method& method, double interval,
               const ApprovedLimit* expected = nullptr) {
  Limit limit = measured(method, interval, {}, expected);
  while (limit.tongues.size() > 1 && limit.tongues.back().from > interval) limit.tongues.pop_back();
  if (limit.stable > 0) limit.at = as_result(run_at(judge, method, interval, limit.stable));
  if (limit.unstable > 0) limit.broken = as_result(run_beyond(quantity, method, interval, limit.unstable));
  limit.within = largest_within_need(judge, quantity, method, interval, expected);
  return limit;
}

void examine(Piece& piece) {
  const Motion& motion = *piece.motion;
  if (motion.varied) {
    piece.row = row_of(motion, *piece.method, piece.on_record);
    return;
  }
  const auto find = [&](const ApprovedLimit* expected) {
    piece.limit = limit_by(*motion.judge, motion.quantity, *piece.method, motion.interval, expected);
    piece.limit.cure = cure_of(motion.quantity, piece.limit);
  };
  find(piece.expected);
  if (piece.expected && !difference(piece.limit, *piece.expected).empty()) find(nullptr);
}

/// The motions at the defaults and at every value of the varied parameter, for the exercises without a
/// failure. Their references may take a while.
std::vector<Motion> motions_of(Results& results, std::span<const Task> tasks, const Reference& truth,
                               const Progress& progress, std::optional<double> horizon) {
  struct Request {
    const Task* task;
    std::size_t place;
    std::optional<double> value;
    Motion motion = {};
    std::string failure = {};
  };
  std::vector<Request> requests;
  for (std::size_t i = 0; i < tasks.size(); ++i)
    if (const auto& scene = tasks[i].entry->exercise.scene;
        scene && results.exercises.at(i).failure.empty()) {
      requests.push_back({&tasks[i], i, std::nullopt});
      for (double value : scene->sweep_values) requests.push_back({&tasks[i], i, value});
    }
  Stage tally(progress, "looking up the motions", requests.size());
  parallel_for_each(requests, [&](Request& request) {
    request.failure = failure_of(
        [&] { request.motion = motion_of(*request.task, request.place, truth, request.value, horizon); });
    tally.add();
  });
  for (const Request& request : requests)
    if (!request.failure.empty()) results.exercises[request.place].failure = request.failure;
  std::vector<Motion> motions;
  for (Request& request : requests)
    if (results.exercises[request.place].failure.empty()) motions.push_back(std::move(request.motion));
  return motions;
}

}  // namespace

double Limit::theory() const { return first_of(tongues); }

double Limit::step() const { return unstable == 0 && tongues.empty() ? infinity : stable; }

Limit measured_limit(const Method& method, double interval, const ode::Criteria& criteria) {
  return measured(method, interval, criteria, nullptr);
}

Limit limit_of(const Quantity& quantity, const Method& method, double interval) {
  return limit_by(EveryStep(quantity, interval * quantity.samples), quantity, method, interval);
}

bool ends_so_within_roundings(const Task& task, const MapRow& row, std::size_t k, Outcome outcome,
                              const Reference& truth) {
  const Motion motion = motion_of(task, 0, truth, row.value);
  const Method* method = method_of(motion.quantity, row.model, row.algorithm);
  return method &&
         any_nearby(motion, *method, static_cast<int>(k), [&](Outcome beside) { return beside == outcome; });
}

namespace {

/// The method's approved limit at the scene's own horizon; null: none.
const ApprovedLimit* expected_of(const Limits* records, const ExerciseResult& exercise,
                                 const Method& method) {
  if (!records) return nullptr;
  const auto found = std::ranges::find_if(*records, [&](const ApprovedLimit& row) {
    return row.exercise == to_string(exercise.number) && row.model == method.model &&
           row.algorithm == method.algorithm;
  });
  return found == records->end() ? nullptr : &*found;
}

}  // namespace

Results with_stability(Results results, std::span<const Task> tasks, const Reference& truth,
                       const Progress& progress, std::optional<double> horizon, const Limits* records) {
  const std::vector<Motion> motions = motions_of(results, tasks, truth, progress, horizon);
  std::vector<Piece> pieces;
  for (const Motion& motion : motions)
    for (const Method& method : motion.quantity.methods)
      if (of_fixed_step(method))
        pieces.push_back({&motion, &method, records != nullptr,
                          expected_of(records, results.exercises[motion.place], method)});
  Stage tally(progress, "looking for the limits of stability", pieces.size());
  parallel_for_each(pieces, [&](Piece& piece) {
    piece.failure = failure_of([&] { examine(piece); });
    tally.add();
  });
  for (const Motion& motion : motions) {
    if (motion.varied) continue;
    Stability& stability =
        results.exercises.at(motion.place).stability.emplace(shape(tasks[motion.place], horizon));
    stability.quantity = motion.quantity.name;
    stability.unit = motion.quantity.unit;
    for (int k = 0; k < map_steps; ++k) stability.steps.push_back(std::ldexp(motion.interval, -k));
  }
  for (Piece& piece : pieces) {
    ExerciseResult& exercise = results.exercises.at(piece.motion->place);
    if (!piece.failure.empty()) {
      exercise.failure = piece.method->model + ", " + piece.method->algorithm + ": " + piece.failure;
    } else if (piece.motion->varied) {
      exercise.stability->map.push_back(std::move(piece.row));
    } else {
      exercise.stability->limits.push_back(std::move(piece.limit));
    }
  }
  for (ExerciseResult& exercise : results.exercises) {
    if (!exercise.stability) continue;
    const auto& limits = exercise.stability->limits;
    std::ranges::stable_sort(exercise.stability->map, {}, [&](const MapRow& row) {
      return std::ranges::find_if(limits,
                                  [&](const Limit& limit) {
                                    return limit.model == row.model && limit.algorithm == row.algorithm;
                                  }) -
             limits.begin();
    });
  }
  return results;
}

double agreement(const Limit& l) {
  const double theory = l.theory();
  if (l.unstable == 0 && theory > l.longest) return 1;
  if (theory == 0 || l.stable == 0)
    return theory == l.stable ? 1 : l.stable == 0 ? 0 : std::numeric_limits<double>::infinity();
  return l.stable / theory;
}

}  // namespace oddity
