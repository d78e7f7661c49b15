#include "report/study/choose.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <ranges>
#include <set>
#include <span>
#include <utility>

#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "reference/text.hpp"
#include "report/study/criterion.hpp"
#include "report/study/in_time.hpp"
#include "report/study/policy.hpp"
#include "report/study/search.hpp"
#include "report/study/stopwatch.hpp"
#include "report/study/time.hpp"
#include "solvers/stop.hpp"

namespace oddity {

namespace {

std::vector<double> sizes_of(const Quantity& motion) {
  const Value& truth = motion.reference.value;
  const std::size_t parts = truth.size() / static_cast<std::size_t>(motion.samples);
  std::vector<double> still;
  for (std::size_t i = 0; i < truth.size(); ++i) still.push_back(truth[i % parts]);
  return motion.errors(Value(std::move(still)));
}

/// A search and its recommendation.
class Recommendation {
 public:
  Recommendation(const Task& task, const Need& need, const Reference& truth, const Price& price,
                 const Progress& progress, std::shared_ptr<const PartJudged> part)
      : task_(task), need_(need), search_(task, need, truth, price, progress, std::move(part)) {}

  Choice choice() {
    const Picked picked = search_.run();
    const std::optional<Candidate>& chosen = picked.chosen;
    const Quantity& motion = starts().motion();
    time_what_is_shown();
    Choice choice;
    choice.need = need_;
    choice.quantity = motion.name;
    for (std::string_view unit : motion.units()) choice.units.emplace_back(unit);
    choice.needs = motion.needs;
    choice.sizes = sizes_of(motion);
    choice.rounding = rounding_of(Criterion::constraint, motion);
    choice.chosen = chosen;
    choice.by_objective = picked.by_objective;
    for (const Start& s : starts().seen()) choice.seen.push_back(s.says);
    if (chosen)
      for (const Start& s : starts().unseen()) choice.unseen.push_back(s.says);
    choice.left_out = starts().left_out();
    choice.failing_nearby = search_.failing_nearby();
    for (Ladder& ladder : search_.ladders())
      if (const Candidate* t = ladder.found(need_).representative()) choice.candidates.push_back(*t);
    for (const Ladder& ladder : search_.ladders())
      if (!ladder.is_over()) choice.left.emplace_back(ladder.method().model, ladder.method().algorithm);
    std::ranges::copy(search_.too_costly(), std::back_inserter(choice.left));
    if (chosen)  // at another setting, where its margin does not matter
      for (Candidate& t : choice.candidates)
        if (t.model == chosen->model && t.algorithm == chosen->algorithm) t = *chosen;
    std::ranges::stable_sort(choice.candidates, {}, [](const Candidate& t) {
      return std::isnan(t.seconds_per_frame) ? std::numeric_limits<double>::infinity() : t.seconds_per_frame;
    });
    for (const std::string_view model : task_.entry->exercise.scene->faulted)
      choice.faulted.emplace_back(model);
    choice.engine = engine();
    choice.predictable = predictable();
    choice.explanation = explanation();
    if (!chosen) {
      choice.nearest_miss = miss(choice.candidates);
      compare_with_asked(choice);
      return choice;
    }
    if (choice.predictable) try_in_chaos(choice);
    choice.ties = picked.ties;
    choice.restart = search_.clock().restart(*chosen);
    choice.in_float = chosen_in_float(*chosen);
    choice.next_cheaper = next_cheaper(*chosen, picked.by_objective);
    choice.next_richer = cheapest(choice.candidates, [&](const Candidate& t) {
      return t.holds() && !picker().is_faulted(t.model) && t.model != chosen->model &&
             t.seconds_per_frame > chosen->seconds_per_frame && !have_same_cost(t, *chosen);
    });
    return choice;
  }

 private:
  Starts& starts() { return search_.starts(); }
  const Starts& starts() const { return search_.starts(); }
  const Picker& picker() const { return search_.picker(); }

  void time_what_is_shown() {
    std::vector<Candidate*> shown;
    for (Ladder& ladder : search_.ladders()) shown.push_back(ladder.found(need_).representative());
    search_.clock().time_all(shown);
  }

  /// The nearest miss when nothing meets the need: the smallest error within the budget, but first a method
  /// that passes and costs too much. Leaves out models that their page shows to be wrong.
  std::optional<Candidate> miss(std::vector<Candidate>& candidates) const {
    auto all =
        candidates | std::views::filter([&](const Candidate& t) { return !picker().is_faulted(t.model); });
    if (all.empty() || starts().seen().empty()) return {};
    if (auto held = cheapest(candidates,
                             [&](const Candidate& t) { return t.holds() && !picker().is_faulted(t.model); }))
      return held;
    const std::span hardest(in_order(starts().seen(), search_.hardest_starts()).front(), 1);
    std::set<const Candidate*> been_on_hardest, been_on_all;
    while (true) {
      Candidate& nearest = *std::ranges::min_element(all, {}, &Candidate::error);
      if (been_on_all.contains(&nearest)) return nearest;
      if (been_on_hardest.insert(&nearest).second) {
        go_through(hardest, nearest, need_);
      } else {
        judge_failure(nearest);
        been_on_all.insert(&nearest);
      }
    }
  }

  /// A failing candidate was left at the first start that it failed on; gives it its error over all starts.
  void judge_failure(Candidate& candidate) const {
    if (!candidate.holds()) go_through(starts().seen(), candidate, need_);
  }

  /// Steps at 60, 120 and 240 Hz, or the next higher rate at which a whole number of steps fills the frame;
  /// each once.
  std::set<double, std::greater<>> steps_of_engines() const {
    std::set<double, std::greater<>> steps;
    for (double rate : {60.0, 120.0, 240.0})
      steps.insert(1 / (need_.frames_per_second * std::ceil(rate / need_.frames_per_second)));
    return steps;
  }

  /// Semi-implicit Euler on the first model that an engine's step fits.
  std::vector<Candidate> engine() const {
    std::vector<Candidate> rows;
    for (const Method& m : starts().motion().methods) {
      if (m.algorithm != "symplectic Euler" && m.algorithm != "semi-implicit Euler") continue;
      for (double step : steps_of_engines()) rows.push_back(evaluate(starts().seen(), m, step, need_));
      break;
    }
    return rows;
  }

  /// Empty if the method exists only in double.
  std::optional<Candidate> chosen_in_float(const Candidate& chosen) const {
    const Method* single = method_of(starts().motion(), chosen.model, oddity::in_float(chosen.algorithm));
    if (!single) return {};
    return evaluate(starts().seen(), *single, chosen.setting, need_);
  }

  /// Only a path has an error in each unit.
  std::optional<double> predictable() const {
    const Start& asked = starts().asked();
    if (need_.criterion != Criterion::path || !asked.parting) return {};
    const Parting& parting = **asked.parting;
    if (!parting.is_chaotic) return {};
    const auto lost = parting.lost_at();
    return lost ? need_.time_of(static_cast<double>(*lost + 1)) : std::numeric_limits<double>::infinity();
  }

  /// A few unseen starts show little about chaos: tries the choice on more of them.
  void try_in_chaos(Choice& choice) {
    const Stopwatch watch(chaos_seconds_);
    const Candidate& chosen = *choice.chosen;
    const std::vector<Start> more = starts().more(policy.tried_in_chaos);
    for (const std::vector<Start>* drawn : {&more, &starts().unseen()})
      for (const Start& start : *drawn) {
        ++choice.tried_in_chaos;
        choice.holding_in_chaos +=
            evaluate(std::span(&start, 1), starts().method(chosen), chosen.setting, need_).holds();
      }
  }

  /// Candidates that are expected to be cheaper and could not be chosen instead, the most expensive first.
  std::vector<Candidate> cheaper_than(const Candidate& chosen, bool by_objective) const {
    std::vector<Candidate> cheaper;
    for (const Ladder& ladder : search_.ladders())
      for (Candidate t : ladder.candidates) {
        t.seconds_per_frame = ladder.expected_seconds(t);
        if (t.seconds_per_frame < chosen.seconds_per_frame && !picker().is_eligible(t, by_objective))
          cheaper.push_back(std::move(t));
      }
    std::ranges::stable_sort(cheaper, std::greater(), &Candidate::seconds_per_frame);
    return cheaper;
  }

  /// A candidate that finishes on the start where it fails first may not finish on another.
  std::optional<Candidate> next_cheaper(const Candidate& chosen, bool by_objective) const {
    for (Candidate& t : cheaper_than(chosen, by_objective)) {
      if (!came_to_an_end(t)) continue;
      judge_failure(t);
      if (!came_to_an_end(t)) continue;
      search_.clock().time(t);
      if (t.seconds_per_frame < chosen.seconds_per_frame) return t;
    }
    return {};
  }

  /// Candidates that may pass on the requested start, by work: they did not fail first on it.
  std::vector<Candidate> maybe_holding_on_asked() const {
    std::vector<Candidate> held;
    for (const Candidate& t : search_.all_tried())
      if (t.where != starts().asked().says && !picker().is_faulted(t.model)) held.push_back(t);
    std::ranges::stable_sort(held, {}, &Candidate::evaluations_per_frame);
    return held;
  }

  /// Reports a method that passes on the requested start, if only the starts next to it rule it out.
  void compare_with_asked(Choice& choice) {
    const std::span<const Start> seen(starts().seen());
    for (Candidate& t : maybe_holding_on_asked()) {
      check_stop();
      const Method& tried = starts().method(t);
      const Candidate on_asked = evaluate(seen.first(1), tried, t.setting, need_);
      if (!on_asked.holds()) continue;
      const Candidate beside =
          evaluate(t.holds() ? starts().unseen() : seen.subspan(1), tried, t.setting, need_);
      if (beside.holds()) continue;
      if (std::isnan(t.seconds_per_frame)) search_.clock().time(t);
      if (!(t.seconds_per_frame <= need_.budget)) continue;
      choice.on_asked = on_asked;
      choice.on_asked->seconds_per_frame = t.seconds_per_frame;
      choice.on_asked->spread = t.spread;
      choice.next_to_asked = beside;
      return;
    }
  }

  /// Everything except the remaining time.
  Explanation explanation() const {
    Explanation all;
    all.truths = starts().seconds();
    all.search = search_.seconds();
    all.timing = search_.clock().seconds();
    all.tests = search_.test_seconds() + chaos_seconds_;
    all.timed = search_.clock().timed();
    all.rounds = search_.rounds();
    const Quantity& motion = starts().motion();
    all.truth_by = motion.reference.by;
    all.truth_error = motion.reference_error / motion.need.allowed;
    all.starts = static_cast<int>(starts().seen().size() + starts().unseen_made());
    if (!starts().asked().is_whole) all.truth_until = need_.time_of(motion.samples);
    all.left = static_cast<int>(search_.too_costly().size());
    all.methods = static_cast<int>(search_.ladders().size()) + all.left;
    for (const Ladder& ladder : search_.ladders()) {
      all.settings += static_cast<int>(ladder.candidates.size());
      if (!ladder.is_over()) ++all.left;
      for (const Candidate& t : ladder.candidates)
        all.evaluations += std::lround(t.evaluations_per_frame * need_.frames());
    }
    return all;
  }

  const Task& task_;
  const Need& need_;
  Search search_;
  double chaos_seconds_ = 0;
};

}  // namespace

Time measured_price(const Method& method, double setting) {
  constexpr double brief = 1e-4, lengthy = 2e-3;  // s, a run
  Time best = time(method, setting, lengthy);
  for (int more = 0; more < 2 && best.seconds < brief; ++more) {
    const Time again = time(method, setting);
    best = {std::min(best.seconds, again.seconds), std::min(best.spread, again.spread)};
  }
  return best;
}

Time counted_price(const Method& method, double setting) {
  constexpr double each = 1e-9;
  return {each * static_cast<double>(method.run(setting).evaluations), 0};
}

std::pair<double, double> Choice::share_in_chaos() const {
  constexpr double z = 1.959964;
  const double n = tried_in_chaos, share = holding_in_chaos / n;
  const double middle = (share + z * z / (2 * n)) / (1 + z * z / n),
               half = z / (1 + z * z / n) * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
  return {middle - half, middle + half};
}

bool Choice::was_followed(const Candidate& t) const {
  return std::ranges::find(left, std::pair(t.model, t.algorithm)) == left.end();
}

namespace {

Choice choose(const Task& task, const Need& need, const Reference& truth, const Price& price,
              const Progress& progress, const std::shared_ptr<const PartJudged>& part) {
  double all = 0;
  Choice choice = [&] {
    const Stopwatch watch(all);
    return in_time(need.time_limit, "a shorter horizon, a lower frame rate or fewer methods (--only)", [&] {
      const Need followed = with_ways(need, task, truth);
      return Recommendation(task, followed, truth, price, progress, part).choice();
    });
  }();
  Explanation& took = choice.explanation;
  took.rest = all - took.truths - took.search - took.timing - took.tests;
  choice.exercise = to_string(task.entry->number);
  choice.time_unit = task.entry->exercise.scene->axes.time;
  return choice;
}

/// Whether a method that fails over a part of the motion fails over the whole. True for an error at every
/// frame that is not relative to the motion's size.
bool a_part_decides(const Need& need) {
  return !need.relative && std::ranges::all_of(criteria_of(need), [](Criterion criterion) {
    return criterion == Criterion::path || criterion == Criterion::constraint;
  });
}

/// Costs over a part, which limit the work over a longer one; those over the part before it for methods that
/// were left out. Where only the budget rules all out, next to the cheapest that passes. Empty if nothing was
/// chosen by the objective.
std::optional<PartCosts> costs_of(const Choice& choice, const std::optional<PartCosts>& before) {
  const std::optional<Candidate>& best = choice.chosen ? choice.chosen : choice.nearest_miss;
  if (!best || !best->holds() || (choice.chosen && !choice.by_objective) || choice.need.thorough) return {};
  const auto cost = [](const Candidate& t, double spread) {
    return PartCosts::Cost{t.seconds_per_frame + spread, t.seconds_per_frame / t.evaluations_per_frame,
                           t.spread / t.seconds_per_frame};
  };
  PartCosts costs{{best->model, best->algorithm}, cost(*best, best->spread)};
  for (const Candidate& t : choice.candidates)
    if (t.seconds_per_frame > 0 && t.evaluations_per_frame > 0)
      costs.all.emplace(PartCosts::Which{t.model, t.algorithm}, cost(t, -t.spread));
  if (before) costs.all.insert(before->all.begin(), before->all.end());
  return costs;
}

/// The need over ever longer parts of its horizon; the last is the whole.
std::vector<Need> ever_longer(const Need& need) {
  std::vector<Need> all{need};
  while (all.front().frames() / policy.longer >= policy.least_frames) {
    Need part = all.front();
    part.horizon = need.time_of(std::floor(part.frames() / policy.longer));
    all.insert(all.begin(), part);
  }
  return all;
}

}  // namespace

Choice choose(const Task& task, const Need& need, const Reference& truth, const Price& price,
              const Progress& progress) {
  return choose(task, need, truth, price, progress, nullptr);
}

Choice choose_in_time(const Task& task, const Need& need, const Reference& truth, const PriceOver& price_over,
                      const Progress& progress) {
  double spent = 0;
  std::optional<Choice> over_part;
  std::shared_ptr<const Failures> failed;
  std::optional<PartCosts> costs;
  bool was_known = false;
  for (Need& over : ever_longer(need)) {
    const bool is_whole = over.horizon == need.horizon;
    std::shared_ptr<PartJudged> part;
    if (a_part_decides(need))
      part =
          std::make_shared<PartJudged>(PartJudged{"the first " + format_significant(over.horizon, 4) + " " +
                                                      std::string(task.entry->exercise.scene->axes.time),
                                                  failed, std::make_shared<Failures>(), costs, was_known});
    try {
      const Stopwatch watch(spent);
      over.time_limit = need.time_limit - spent;
      over_part = choose(task, over, truth, price_over(over), progress, part);
      costs = costs_of(*over_part, costs);
      was_known = !over_part->explanation.truth_until;
    } catch (const OutOfTime&) {
      if (!over_part) throw;
      break;
    } catch (const BadInput&) {
      if (is_whole) throw;
      continue;  // two periods, for example, may fit only in the whole
    }
    if (is_whole) return *over_part;
    over_part->asked_horizon = need.horizon;
    over_part->is_decided_by_part = !over_part->chosen && part && !std::isfinite(need.budget);
    if (over_part->is_decided_by_part) break;
    if (!part) continue;
    if (failed) part->here->add(*failed);
    failed = part->here;
  }
  return *over_part;
}

}  // namespace oddity
