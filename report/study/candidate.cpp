#include "report/study/candidate.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <exception>
#include <optional>

#include "reference/bad_input.hpp"
#include "reference/text.hpp"
#include "report/study/criterion.hpp"
#include "report/study/frames.hpp"
#include "report/study/off_by_need.hpp"
#include "report/study/parallel.hpp"
#include "solvers/ode/catalog.hpp"

namespace oddity {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Steps per frame from 1 on, each about half as many again as the one before at most.
constexpr std::array steps_per_frame{1,  2,  3,  4,  5,  6,  8,   10,  12,  16,  20,  24,
                                     32, 40, 48, 64, 80, 96, 128, 160, 192, 256, 384, 512};

/// The trial's errors in each unit, at least the error of its reference.
std::vector<double> as_far_as_known(const Quantity& motion, const Trial& trial) {
  std::vector<double> errors = trial.errors;
  for (double& error : errors)
    if (error < motion.reference_error) error = motion.reference_error;
  return errors;
}

/// Result of a method at a setting on one start.
struct Judged {
  Trial trial;
  std::vector<double> errors = {};  ///< in each unit
  OffByNeed off = {unbounded};
  const Start* by_start = nullptr;  ///< the start whose reference judged it
};

Trial missing(const Candidate& c) {
  return {c.model, c.algorithm,  {},           c.setting,    {},
          {},      not_a_number, not_a_number, not_a_number, Outcome::raised};
}

/// Judges by every criterion of the need.
Judged judge_at(const Start& start, const Candidate& c, const Need& need) {
  const Quantity& motion = start.motion;
  const Method* here = method_of(motion, c.model, c.algorithm);
  Judged judged{here ? run(motion, *here, c.setting) : missing(c)};
  judged.by_start = &start;
  judged.errors = as_far_as_known(motion, judged.trial);
  if (!here) return judged;
  judged.off =
      off_by(need, motion, *here, judged.trial, judged.errors, start.energy ? &**start.energy : nullptr);
  return judged;
}

/// Whether a better reference would not change the outcome. Passing is certain only on a whole motion. So is
/// the margin, unless the reference is known very well anyway.
bool is_decided(double error, double known_to, bool on_whole, const Need& need) {
  if (error - known_to > 1) return true;
  return on_whole && error + known_to <= 1 &&
         (known_to <= known_very_well || std::abs(error - 1 / need.margin()) > known_to);
}

/// Takes a better reference where the one at hand does not decide.
Judged judge(const Start& start, const Candidate& candidate, const Need& need) {
  Judged by_first = judge_at(start, candidate, need);
  const double known_to = start.motion.reference_error / start.motion.need.allowed;
  if (!start.sharper || is_decided(by_first.off.error, known_to, start.is_whole, need)) return by_first;
  return judge(**start.sharper, candidate, need);
}

/// Error in needs up to each frame, less the uncertainty of the reference.
std::vector<double> certain_errors_until(const Quantity& motion, const Value& path) {
  std::vector<double> until = errors_until(motion, path);
  const auto& known = motion.reference_error_until;
  for (std::size_t k = 0; k < until.size(); ++k) {
    const double known_to = k < known.size() ? known[k] : motion.reference_error;
    until[k] = std::max(0.0, until[k] - known_to / motion.need.allowed);
  }
  return until;
}

/// The error as it would be if the motion's size did not bound it.
double unbounded_error(const Judged& judged) {
  if (!judged.by_start->parting || judged.off.error <= 1 || !(**judged.by_start->parting).is_chaotic)
    return judged.off.error;
  const std::vector<double> until = certain_errors_until(judged.by_start->motion, judged.trial.answer.value);
  return until.empty() ? judged.off.error
                       : std::max(judged.off.error, (**judged.by_start->parting).in_the_end(until));
}

/// Outcome of a trial that does not pass.
Outcome failure(const Trial& trial) {
  return trial.outcome == Outcome::ok ? Outcome::inaccurate : trial.outcome;
}

Candidate untried(const Method& method, double setting) {
  Candidate candidate{method.model, method.algorithm, method.resolution.name, setting};
  candidate.precision = method.precision;
  candidate.state_size = method.state_size;
  return candidate;
}

OnStart on_start(const Start& start, const Candidate& candidate, const Need& need) {
  const auto make = [&] {
    Judged judged = judge(start, candidate, need);
    return OnStart{std::move(judged.errors),
                   judged.off.by,
                   judged.off.why,
                   judged.off.error,
                   unbounded_error(judged),
                   static_cast<double>(judged.trial.answer.evaluations) / judged.by_start->motion.samples,
                   judged.off.error <= 1 ? Outcome::ok : failure(judged.trial)};
  };
  return start.attempts ? start.attempts->at(candidate, make) : make();
}

/// The result on a first part of the motion, if the method already fails there.
std::optional<OnStart> failed_before(const Start& start, const Candidate& candidate) {
  return start.part && start.part->before ? start.part->before->find(start.says, candidate)
                                          : std::optional<OnStart>();
}

/// Skips the whole motion if the method fails on a first part of it.
OnStart on_start_or_part(const Start& start, const Candidate& candidate, const Need& need) {
  if (auto before = failed_before(start, candidate)) return *before;
  OnStart on = on_start(start, candidate, need);
  if (!start.part || on.outcome == Outcome::ok || on.outcome == Outcome::stalled) return on;
  OnStart over_this = on;
  over_this.why = "its error is that of " + start.part->says;
  start.part->here->add(start.says, candidate, over_this);
  return on;
}

/// Adds the result on a start to the candidate's. Returns the evaluations per frame there.
double add(const Start& start, Candidate& candidate, const OnStart& on) {
  if (on.outcome != Outcome::ok && (candidate.holds() || on.error > candidate.error)) {
    candidate.outcome = on.outcome;
    candidate.where = start.says;
    candidate.why = on.why;
  }
  for (const auto& [criterion, off] : on.by) candidate.by[criterion] = std::max(candidate.by[criterion], off);
  candidate.error = std::max(candidate.error, on.error);
  candidate.unbounded_error = std::max(candidate.unbounded_error, on.unbounded_error);
  candidate.errors.resize(start.motion.units().size(), 0);
  for (std::size_t i = 0; i < on.errors.size(); ++i)
    candidate.errors[i] =
        std::isfinite(on.errors[i]) ? std::max(candidate.errors[i], on.errors[i]) : unbounded;
  return on.evaluations_per_frame;
}

}  // namespace

std::vector<double> settings(const Method& method, const Need& need) {
  std::vector<double> all;
  if (method.resolution.name == "step") {
    const bool differ = need.frame_times && stepping_of(method.algorithm) == Stepping::divided;
    if (differ) all.push_back(need.frame_times->longest);
    for (int steps : steps_per_frame)
      if (const double step = 1 / (need.frames_per_second * steps); !differ || step < all.front())
        all.push_back(step);
  } else if (method.resolution.name == "tolerance")
    all = tolerances(2, 13, 1).settings;
  else
    all = method.resolution.settings;
  return all;
}

Candidate evaluate(std::span<const Start> starts, const Method& method, double setting, const Need& need) {
  Candidate candidate = untried(method, setting);
  go_through(starts, candidate, need);
  return candidate;
}

void go_through(std::span<const Start> starts, Candidate& candidate, const Need& need) {
  std::string been_on = candidate.where;
  if (std::ranges::any_of(starts, [&](const Start& start) {
        return start.says == been_on && failed_before(start, candidate);
      }))
    been_on = candidate.why = "";  // left by an evaluation over a part of the motion
  std::vector<std::optional<OnStart>> on(starts.size());
  in_parallel(starts.size(), [&](std::size_t i) {
    if (starts[i].says != been_on) on[i] = on_start(starts[i], candidate, need);
  });
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (!on[i]) continue;
    const double evaluations = add(starts[i], candidate, *on[i]);
    if (i == 0) candidate.evaluations_per_frame = evaluations;
  }
}

Order in_order(std::span<const Start> starts, std::span<const std::string> first) {
  Order order;
  for (const Start& start : starts) order.push_back(&start);
  const auto place = [&](const Start* start) { return std::ranges::find(first, start->says); };
  std::ranges::stable_sort(order, {}, place);
  return order;
}

Candidate evaluate_until_one_fails(const Order& starts, const Method& method, double setting,
                                   const Need& need, double most_evaluations) {
  Candidate candidate = untried(method, setting);
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> one_fails = false;  // all starts before it have begun
  std::vector<std::optional<OnStart>> on(starts.size());
  std::vector<std::exception_ptr> thrown(starts.size());  // count only if all starts before them pass
  const auto try_next = [&](std::size_t) {
    if (one_fails) return;
    const ode::EvaluationLimit limited(most_evaluations);
    const std::size_t i = next++;
    try {
      on[i] = on_start_or_part(*starts[i], candidate, need);
    } catch (...) {
      thrown[i] = std::current_exception();
    }
    if (thrown[i] || on[i]->outcome != Outcome::ok) one_fails = true;
  };
  try_next(0);
  in_parallel(starts.size() - 1, try_next);
  for (std::size_t i = 0; candidate.holds() && i < starts.size(); ++i) {
    if (thrown[i]) std::rethrow_exception(thrown[i]);
    const double evaluations = add(*starts[i], candidate, on[i].value());
    if (i == 0) candidate.evaluations_per_frame = evaluations;
  }
  return candidate;
}

std::string shown_setting(const Candidate& candidate, const Need& need) {
  if (candidate.resolution != "step")
    return candidate.resolution.empty() ? "-"
                                        : candidate.resolution + " " + format_shortest(candidate.setting);
  if (need.frame_times && candidate.setting != need.frame_times->longest)
    return (stepping_of(candidate.algorithm) == Stepping::divided ? "steps up to " : "steps of ") +
           shown_length(candidate.setting, need.frame_times->unit);
  const double steps = need.frame_times ? 1 : std::round(1 / (candidate.setting * need.frames_per_second));
  return format_shortest(steps) + (steps == 1 ? " step" : " steps") + " per frame";
}

std::string shown_rate(const Need& need, std::string_view time_unit) {
  return "at " + format_shortest(need.frames_per_second) + " frames per " +
         (time_unit == "s" ? "second" : std::string(time_unit)) +
         (need.frame_times ? ", " + need.frame_times->says : "") +
         (need.kicks ? ", with the kick " + need.kicked : "");
}

std::string shown_span(const Need& need, std::string_view time_unit) {
  const std::string unit(time_unit);
  const double judged = need.time_of(need.frames());
  const bool as_asked = need.frame_times || std::abs(judged - need.horizon) <= 1e-9 * need.horizon;
  return (as_asked ? format_shortest(need.horizon) + " " + unit
                   : format_shortest(need.frames()) + (need.frames() == 1 ? " frame, " : " frames, ") +
                         format_significant(judged, 3) + " " + unit + ",") +
         " " + shown_rate(need, time_unit);
}

bool hopeless(const Candidate& candidate) {
  return candidate.outcome == Outcome::raised || candidate.evaluations_per_frame > 1e5;
}

}  // namespace oddity
