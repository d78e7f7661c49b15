#include "report/study/trajectory.hpp"

#include <algorithm>
#include <cmath>

#include "reference/reference.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace {

constexpr int samples = 240;

bool better(const TimedTrial& a, const TimedTrial& b) {
  return a.error < b.error || (std::isfinite(a.error) && !std::isfinite(b.error));
}

/// The best of each model's finest trials, in the models' order.
std::vector<const TimedTrial*> best_of_models(const QuantityResult& q) {
  std::vector<const TimedTrial*> best;
  for (const MethodResult& m : q.methods) {
    const TimedTrial& finest = m.trials.back();
    const auto same = std::ranges::find(best, m.model, [](const TimedTrial* t) { return t->model; });
    if (same == best.end())
      best.push_back(&finest);
    else if (better(finest, **same))
      *same = &finest;
  }
  return best;
}

/// Runs the trial's method again; empty if it throws.
Answer again(const Quantity& seen, const TimedTrial& t) {
  for (const Method& m : seen.methods)
    if (m.model == t.model && m.algorithm == t.algorithm) return run(seen, m, t.setting).answer;
  throw std::logic_error("the motion has no method '" + t.model + ", " + t.algorithm + "'");
}

/// Rounds to the digits that a picture shows.
Value to_be_drawn(const Value& value) {
  std::vector<double> drawn;
  for (double x : value) drawn.push_back(parse_number(format_significant(x, 7)).value_or(x));
  return drawn;
}

}  // namespace

std::optional<Trajectory> trajectory(const Scene& scene, const Parameters& parameters,
                                     const QuantityResult& judged) {
  const Horizon horizon{scene.horizon, samples};
  const Quantity seen = scene.motion(parameters, horizon, Reference::nothing());
  Trajectory all{{scene.axes.observables.begin(), scene.axes.observables.end()},
                 std::string(scene.axes.time),
                 Horizon{scene.horizon}.times(),
                 horizon.times(),
                 {},
                 0,
                 scene.game_tolerance};
  all.judged_at.erase(all.judged_at.begin());
  all.times.erase(all.times.begin());
  const TimedTrial* truest = nullptr;
  for (const TimedTrial* t : best_of_models(judged)) {
    const Answer answer = again(seen, *t);
    if (t->outcome == Outcome::ok && answer.reached() && (!truest || better(*t, *truest))) {
      truest = t;
      all.truest = all.paths.size();
    }
    all.paths.push_back(
        {t->model, t->algorithm, t->resolution, t->setting, t->error, t->outcome, to_be_drawn(answer.value)});
  }
  if (!truest) return {};
  return all;
}

}  // namespace oddity
