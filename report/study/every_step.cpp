#include "report/study/every_step.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace oddity {

namespace {

bool is_truer(const Trial& a, const Trial& b) {
  constexpr double enough = 1e-6;
  if (a.in_needs <= enough && b.in_needs <= enough) return a.answer.evaluations < b.answer.evaluations;
  return a.in_needs < b.in_needs;
}

}  // namespace

bool of_fixed_step(const Method& method) { return static_cast<bool>(method.unstable_steps); }

EveryStep::EveryStep(Quantity at_looks, double horizon, MotionAt motion, OffBy off_by)
    : at_looks_(std::move(at_looks)),
      horizon_(horizon),
      motion_(std::move(motion)),
      off_by_(std::move(off_by)) {
  if (!motion_) return;
  for (const Method& method : at_looks_.methods)
    if (!of_fixed_step(method)) consider(method);
}

void EveryStep::consider(const Method& method) {
  for (double setting : method.resolution.settings) {
    const Trial trial = run(at_looks_, method, setting);
    if (trial.answer.reached() && std::isfinite(trial.in_needs) && (!truest_ || is_truer(trial, *truest_)))
      truest_ = trial;
  }
}

Quantity EveryStep::motion_at(long looks) const {
  Quantity dense = motion_({horizon_, static_cast<int>(looks)});
  dense.need = at_looks_.need;
  dense.needs = at_looks_.needs;
  dense.reference.value = method_of(dense, truest_->model, truest_->algorithm)->run(truest_->setting).value;
  return dense;
}

EveryStep::Judged EveryStep::at_looks(const Method& method, long steps) const {
  Trial trial = run(at_looks_, method, horizon_ / static_cast<double>(steps * at_looks_.samples));
  const double off = trial.in_needs;
  return {std::move(trial), off};
}

EveryStep::Judged EveryStep::judged(const Method& method, long steps) const {
  const long all = steps * at_looks_.samples;
  if (!truest_) return at_looks(method, steps);
  const long each = (all + most_looks - 1) / most_looks, looks = (all + each - 1) / each;
  const Quantity dense = motion_at(looks);
  const Method& same = *method_of(dense, method.model, method.algorithm);
  Judged judged{run(dense, same, horizon_ / static_cast<double>(looks * each)), 0};
  judged.off = off_by_ ? off_by_(dense, same, judged.trial) : judged.trial.in_needs;
  const Value& seen = judged.trial.answer.value;
  judged.trial.answer.value = std::vector<double>(
      seen.end() - static_cast<std::ptrdiff_t>(seen.size() / static_cast<std::size_t>(looks)), seen.end());
  return judged;
}

namespace {

constexpr long enough_steps = 4096, most_steps = 262'144, most_evaluations = 200'000;

/// The next finer number of steps that is tried.
long finer(long steps) { return std::max(steps + 1, std::lround(static_cast<double>(steps) * 1.5)); }

/// The next coarser number of steps that bisection distinguishes from this one.
long apart(long steps) { return std::max(1L, steps / 100); }

bool is_most(long steps, double evaluations) {
  return steps >= most_steps || evaluations >= most_evaluations;
}

/// Elsewhere too if the path is judged and passes at the few times of the reference.
EveryStep::Judged judged_early(const EveryStep& judge, const Method& method, long steps) {
  EveryStep::Judged looked = judge.at_looks(method, steps);
  return looked.off <= 1 ? judge.judged(method, steps) : looked;
}

}  // namespace

std::optional<TimedTrial> within_need(const EveryStep& judge, const Method& method, int intervals,
                                      bool path_is_asked) {
  const auto judged = [&](long steps) {
    return path_is_asked ? judged_early(judge, method, steps) : judge.judged(method, steps);
  };
  std::optional<TimedTrial> within;
  long coarse = 0,
       fine = 0;  // steps per interval: the finest that fails, the coarsest of the passing ones below
  for (long steps = 1;; steps = finer(steps)) {
    const auto [here, off] = judged(steps);
    if (!(off <= 1)) {
      coarse = steps;
      within.reset();
    } else if (!within) {
      fine = steps;
      within = as_result(here);
    }
    const long all = steps * intervals;
    if (is_most(all, static_cast<double>(here.answer.evaluations))) break;
    if (within && all >= enough_steps) break;
  }
  while (within && fine - coarse > apart(fine)) {
    const long middle = std::midpoint(coarse, fine);
    const auto [here, off] = judged(middle);
    (off <= 1 ? fine : coarse) = middle;
    if (off <= 1) within = as_result(here);
  }
  return within;
}

std::optional<TimedTrial> confirmed_within_need(const EveryStep& judge, const Method& method, int intervals,
                                                double expected_steps) {
  const auto judged = [&](long steps) { return judged_early(judge, method, steps); };
  const long expected = std::lround(expected_steps), margin = expected / 100;
  const long fine = expected + margin, coarse = expected - std::max(1L, 2 * margin);
  if (coarse > 0 && judged(coarse).off <= 1) return std::nullopt;
  const auto [here, off] = judged(fine);
  if (!(off <= 1)) return std::nullopt;
  for (const long steps : {finer(fine), (enough_steps - 1) / intervals + 1})
    if (steps > fine && !(judged(steps).off <= 1)) return std::nullopt;
  return as_result(here);
}

bool is_never_within_need(const EveryStep& judge, const Method& method, int intervals) {
  const double each = static_cast<double>(judge.at_looks(method, 1).trial.answer.evaluations);
  long steps = 1;
  while (!is_most(steps * intervals, each * static_cast<double>(steps))) steps = finer(steps);
  const auto fails = [&](long tried) { return !(judge.at_looks(method, tried).off <= 1); };
  return fails(steps) && fails((enough_steps - 1) / intervals + 1);
}

}  // namespace oddity
