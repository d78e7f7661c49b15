#include "report/study/held_steps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

#include "chapters/scene.hpp"
#include "reference/bad_input.hpp"
#include "report/study/every_step.hpp"
#include "report/study/initial_conditions.hpp"
#include "report/study/off_by_need.hpp"
#include "report/study/parallel.hpp"
#include "report/study/stability.hpp"
#include "solvers/ode/step_lengths.hpp"

namespace oddity {

namespace {

/// Judges by a need, at any times. Thread-safe.
class ByNeed {
 public:
  explicit ByNeed(const Need& need) : need_(need) {}

  /// Throws BadInput if the true motion has no such energy or period.
  double off_or_throw(const Quantity& truth, const Method& method, const Trial& trial) {
    const TrueEnergy* energy = needs_energy(need_) ? &energy_of(truth) : nullptr;
    return off_by(need_, truth, method, trial, trial.errors, energy).error;
  }
  /// Infinite if there are too few times for a period.
  double off(const Quantity& truth, const Method& method, const Trial& trial) {
    try {
      return off_or_throw(truth, method, trial);
    } catch (const BadInput&) {
      return std::numeric_limits<double>::infinity();
    }
  }

 private:
  /// Computed once for a number of times, as many methods are judged at the same ones.
  const TrueEnergy& energy_of(const Quantity& truth) {
    const std::lock_guard lock(mutex_);
    auto& energy = energies_[truth.samples];
    if (!energy) energy = std::make_unique<TrueEnergy>(true_energy(truth));
    return *energy;
  }

  const Need& need_;
  std::map<int, std::unique_ptr<TrueEnergy>> energies_;
  std::mutex mutex_;
};

bool asks_for(const Need& need, Criterion criterion) {
  return std::ranges::count(criteria_of(need), criterion) > 0;
}

void require_known(const EveryStep& judge, const Quantity& seen, const Need& need) {
  constexpr double well = 0.1;  // fraction of the need
  const auto& truest = judge.truest();
  if (!truest)
    throw BadInput(
        "no method without a fixed step follows the motion over this horizon: ask for a shorter one");
  const bool by_motion = asks_for(need, Criterion::path) || asks_for(need, Criterion::period);
  if (by_motion && !(truest->in_needs <= well && seen.reference_error <= well * seen.need.allowed))
    throw BadInput(
        "the true motion is not known to a tenth of the requested error over this horizon: ask for a "
        "shorter horizon or a larger error");
}

}  // namespace

HeldSteps held_steps(const Task& task, const Need& need, const Reference& truth, const Progress& progress) {
  const Scene& scene = *task.entry->exercise.scene;
  Quantity seen = motion(scene, task.parameters, {need.horizon}, truth);
  seen.needs = needs_of(need, seen);
  seen.need = {*std::ranges::min_element(seen.needs), "asked for"};
  std::vector<const Method*> all, judged;
  for (const Method& method : seen.methods) {
    all.push_back(&method);
    if (of_fixed_step(method) && can_be_judged(need, seen, method)) judged.push_back(&method);
  }
  require_constraint(need, seen, all);

  ByNeed by_need(need);
  const EveryStep judge(
      seen, need.horizon,
      [&](const Horizon& horizon) { return motion(scene, task.parameters, horizon, Reference::nothing()); },
      [&](const Quantity& at, const Method& method, const Trial& trial) {
        return by_need.off(at, method, trial);
      });
  require_known(judge, seen, need);
  const Quantity finest = judge.motion_at(EveryStep::most_looks);
  const Method& truest = *method_of(finest, judge.truest()->model, judge.truest()->algorithm);
  by_need.off_or_throw(finest, truest, run(finest, truest, judge.truest()->setting));

  Stage tally(progress, "looking for the steps that hold", judged.size());
  std::vector<double> longest(judged.size());
  in_parallel(judged.size(), [&](std::size_t i) {
    const auto within = within_need(judge, *judged[i], seen.samples, asks_for(need, Criterion::path));
    longest[i] = within ? within->setting : 0;
    tally.add();
  });
  HeldSteps held;
  for (std::size_t i = 0; i < judged.size(); ++i)
    held.longest[{judged[i]->model, judged[i]->algorithm}] = longest[i];
  return held;
}

void find_stable_at_frames(HeldSteps& held, const Task& task, const FramesAsked& frames, double horizon,
                           const Progress& progress) {
  constexpr std::size_t enough = 20'000;
  const Quantity seen = motion(*task.entry->exercise.scene, task.parameters, {horizon}, Reference::nothing());
  const std::vector<double> lengths = frame_lengths(frames, enough);
  std::vector<const Method*> fixed;
  for (const Method& method : seen.methods)
    if (of_fixed_step(method) && !ode::is_multistep(method.algorithm)) fixed.push_back(&method);
  Stage tally(progress, "looking for the frames that are stable", fixed.size());
  std::vector<double> stable(fixed.size());
  in_parallel(fixed.size(), [&](std::size_t i) {
    const ode::StepLengths here(lengths);
    stable[i] = measured_limit(*fixed[i], horizon / seen.samples).step();
    tally.add();
  });
  held.frames = says(frames, std::string(task.entry->exercise.scene->axes.time));
  held.longest_frame = std::ranges::max(lengths);
  for (std::size_t i = 0; i < fixed.size(); ++i)
    held.stable_at_frames[{fixed[i]->model, fixed[i]->algorithm}] = stable[i];
}

}  // namespace oddity
