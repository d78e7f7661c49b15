#include "report/study/frame_clock.hpp"

#include <algorithm>
#include <cmath>

#include "report/study/parallel.hpp"
#include "report/study/policy.hpp"
#include "report/study/stopwatch.hpp"
#include "solvers/stop.hpp"

namespace oddity {

namespace {

Time part_of(const Time& time, double parts) { return {time.seconds / parts, time.spread / parts}; }

double evaluations_of(const Quantity& motion, const Method& method, double setting) {
  return static_cast<double>(run(motion, method, setting).answer.evaluations);
}

}  // namespace

void FrameClock::time(Candidate& candidate) const {
  const Time time = time_per_frame(candidate);
  double times = 1 + restarting(candidate);
  if (times * time.seconds <= need_.budget) times *= worst_part(candidate);
  candidate.seconds_per_frame = times * time.seconds;
  candidate.spread = std::isfinite(time.spread) ? times * time.spread : 0;
}

bool FrameClock::time_all(const std::vector<Candidate*>& candidates) {
  const Stopwatch watch(seconds_);
  std::vector<Candidate*> untimed;
  std::ranges::copy_if(candidates, std::back_inserter(untimed),
                       [](const Candidate* t) { return t && std::isnan(t->seconds_per_frame); });
  timed_ += static_cast<int>(untimed.size());
  Stage tally(progress_, "timing them", untimed.size());
  for (Candidate* candidate : untimed) {
    check_stop();
    time(*candidate);
    tally.add();
  }
  return !untimed.empty();
}

/// Evaluations per frame in the costliest part of the horizon, over the average: a budget that holds on
/// average has to hold there as well.
double FrameClock::worst_part(const Candidate& candidate) const {
  const auto frames = static_cast<int>(need_.frames());
  constexpr auto parts = static_cast<std::size_t>(policy.budget_parts);
  const double average = candidate.evaluations_per_frame;
  if (!std::isfinite(need_.budget) || average == 0 || frames < policy.budget_parts) return 1;
  const auto end_of = [&](std::size_t part) { return static_cast<int>(part) * frames / policy.budget_parts; };
  std::vector<double> until(parts + 1, 0);
  const auto count = [&](std::size_t part) {
    const Quantity seen = starts_.first_frames(end_of(part));
    const Method* method = method_of(seen, candidate.model, candidate.algorithm);
    if (method) until[part] = evaluations_of(seen, *method, candidate.setting);
  };
  count(1);
  if (until[1] == 0) return 1;
  // Fixed steps take the same number of evaluations each, except the first ones of a multistep method.
  const double later = (std::round(average * frames) - until[1]) / (frames - end_of(1));
  if (later == std::round(later)) return std::max(1.0, std::max(later, until[1] / end_of(1)) / average);
  in_parallel(parts - 1, [&](std::size_t i) { count(i + 2); });
  double most = 0;
  for (std::size_t part = 1; part <= parts; ++part)
    most = std::max(most, (until[part] - until[part - 1]) / (end_of(part) - end_of(part - 1)));
  return std::max(1.0, most / average);
}

/// Times a long run over its first frames only, as an evaluation takes as long there: over a twentieth of
/// all, or over enough for twice `policy.long_evaluations`.
Time FrameClock::time_per_frame(const Candidate& candidate) const {
  const double enough = std::ceil(2 * policy.long_evaluations / candidate.evaluations_per_frame);
  const Quantity first_frames =
      starts_.first_frames(static_cast<int>(std::clamp(enough, 1.0, std::max(1.0, need_.frames() / 20))));
  const Method* briefly = method_of(first_frames, candidate.model, candidate.algorithm);
  const double evaluations = briefly ? evaluations_of(first_frames, *briefly, candidate.setting) : 0;
  if (evaluations < policy.long_evaluations)
    return part_of(price_(starts_.method(candidate), candidate.setting), starts_.motion().samples);
  return part_of(price_(*briefly, candidate.setting), evaluations / candidate.evaluations_per_frame);
}

double FrameClock::restart(const Candidate& candidate) const {
  const Quantity one_frame = starts_.first_frames(1);
  const Method* first = method_of(one_frame, candidate.model, candidate.algorithm);
  if (!first) return 0;
  return std::max(0.0,
                  evaluations_of(one_frame, *first, candidate.setting) - candidate.evaluations_per_frame);
}

/// Relative increase of the time by the requested restarts.
double FrameClock::restarting(const Candidate& candidate) const {
  const double frames = need_.restart_every * need_.frames_per_second;
  if (!std::isfinite(frames) || candidate.evaluations_per_frame == 0) return 0;
  return restart(candidate) / candidate.evaluations_per_frame / frames;
}

}  // namespace oddity
