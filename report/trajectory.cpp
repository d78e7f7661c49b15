#include "report/trajectory.hpp"

#include <algorithm>
#include <cmath>

#include "reference/reference.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace {

constexpr int samples = 240;

/// A model's finest trial with the least error, and its place among the methods; those with no error at all
/// are worse than any.
struct Best {
  std::size_t method;
  const TimedTrial* trial;
};

bool better(const TimedTrial& a, const TimedTrial& b) {
  return a.error < b.error || (std::isfinite(a.error) && !std::isfinite(b.error));
}

std::vector<Best> best_of_models(const QuantityResult& q) {
  std::vector<Best> best;
  for (std::size_t i = 0; i < q.methods.size(); ++i) {
    const TimedTrial& finest = q.methods[i].trials.back();
    const auto same =
        std::ranges::find_if(best, [&](const Best& b) { return b.trial->model == q.methods[i].model; });
    if (same == best.end())
      best.push_back({i, &finest});
    else if (better(finest, *same->trial))
      *same = {i, &finest};
  }
  return best;
}

/// Everything that a picture shows, and no more digits.
Value to_be_drawn(const Value& value) {
  std::vector<double> drawn;
  for (double x : value) drawn.push_back(number_in(rounded(x, 7)).value_or(x));
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
                 0};
  all.judged_at.erase(all.judged_at.begin());
  all.times.erase(all.times.begin());
  const TimedTrial* truest = nullptr;
  for (const Best& best : best_of_models(judged)) {
    const TimedTrial& t = *best.trial;
    Answer answer;
    try {
      answer = seen.methods.at(best.method).run(t.setting);
    } catch (const std::exception&) {
      answer.value = {};
    }
    if (t.outcome == Outcome::ok && (!truest || better(t, *truest))) {
      truest = &t;
      all.truest = all.paths.size();
    }
    all.paths.push_back(
        {t.model, t.algorithm, t.knob, t.setting, t.error, t.outcome, to_be_drawn(answer.value)});
  }
  if (!truest) return {};
  return all;
}

}  // namespace oddity
