#include "report/study/run.hpp"

#include <algorithm>
#include <deque>
#include <numeric>

#include "reference/ledger.hpp"
#include "reference/text.hpp"
#include "report/study/failure.hpp"
#include "report/study/findings.hpp"
#include "report/study/frames.hpp"
#include "report/study/parallel.hpp"
#include "report/study/time.hpp"
#include "report/study/trajectory.hpp"

namespace oddity {

namespace {

/// A task with its findings, before closures become plain values.
struct Studied {
  const Task* task;
  Findings findings;
  std::string failure;
};

/// A trial to run, and the places for its result and, if kept, the whole trial.
struct Pending {
  const Quantity* quantity;
  const Method* method;
  double setting;
  TimedTrial* result;
  Trial* kept = nullptr;
};

/// A breakdown whose text still needs the numbers of its trials.
struct Unfilled {
  const Quantity* quantity;
  const Breakdown* breakdown;
  BreakdownResult* result;
  Trial broken = {}, cured = {};
};

/// The work to do; its `unfilled` entries do not move.
struct Work {
  std::vector<Pending> pending;
  std::deque<Unfilled> unfilled;
};

Studied study(const Task& task, const Reference& truth) {
  Studied studied{&task, {}, {}};
  const Exercise& exercise = task.entry->exercise;
  studied.failure = failure_of([&] {
    if (!task.frames) {
      studied.findings = exercise.study(task.parameters, truth);
      return;
    }
    Quantity motion = motion_at_frames(*exercise.scene, task.parameters, *task.frames, truth, task.kicks);
    motion.says += ", " + task.frames_text;
    if (task.kicks)
      motion.says += "; an error of " + format_significant(motion.reference_error, 2) +
                     " is at most that, as the truth is not known better";
    studied.findings.quantities = {std::move(motion)};
  });
  return studied;
}

const Method& method_named(const Quantity& quantity, const std::string& name) {
  for (const auto* methods : {&quantity.methods, &quantity.methods_in_float})
    for (const Method& method : *methods)
      if (method.model + ", " + method.algorithm == name) return method;
  throw std::logic_error("quantity " + quantity.name + " has no method '" + name + "'");
}

std::size_t like_in_double(const Quantity& quantity, const Method& single) {
  const auto found = std::ranges::find_if(quantity.methods, [&](const Method& m) {
    return m.model == single.model && in_float(m.algorithm) == single.algorithm;
  });
  if (found == quantity.methods.end())
    throw std::logic_error(single.model + ", " + single.algorithm + " has no like one in double");
  return static_cast<std::size_t>(found - quantity.methods.begin());
}

/// Whether a task is the unmodified exercise, with its own parameters and times.
bool is_own(const Task& task) {
  return !task.frames && !task.kicks &&
         std::ranges::all_of(task.entry->exercise.parameters,
                             [&](const Parameter& p) { return task.parameters[p.name] == p.value; });
}

bool asserts_outcome(const Task& task, const Quantity& quantity, const Method& method) {
  return is_own(task) || (task.entry->exercise.expected == Expected::in_whole_ranges &&
                          !quantity.for_own_parameters && !method.for_own_parameters);
}

/// The result's shape; its trials are still empty but registered in `work`.
QuantityResult shape(const Quantity& quantity, const Task& task, Work& work) {
  QuantityResult result{quantity.name,
                        quantity.unit,
                        quantity.says,
                        quantity.reference,
                        quantity.reference_error,
                        quantity.need,
                        {},
                        {},
                        {},
                        quantity.samples,
                        {},
                        {},
                        quantity.in_operations};
  for (const Norm& norm : quantity.norms) result.norms.push_back(norm.components);
  for (const Method& method : quantity.methods)
    result.methods.push_back({method.model, method.algorithm, method.expected, method.why,
                              std::vector<TimedTrial>(method.resolution.settings.size()),
                              asserts_outcome(task, quantity, method)});
  for (const Method& method : quantity.methods_in_float)
    result.in_float.push_back({method.model, method.algorithm, like_in_double(quantity, method),
                               std::vector<TimedTrial>(method.resolution.settings.size())});
  for (const Breakdown& breakdown : quantity.breakdowns)
    result.breakdowns.push_back({{}, breakdown.outcome, {}, {}});
  const auto all_of = [&](const Method& method, std::vector<TimedTrial>& trials) {
    for (std::size_t s = 0; s < trials.size(); ++s)
      work.pending.push_back({&quantity, &method, method.resolution.settings[s], &trials[s]});
  };
  for (std::size_t m = 0; m < quantity.methods.size(); ++m)
    all_of(quantity.methods[m], result.methods[m].trials);
  for (std::size_t m = 0; m < quantity.methods_in_float.size(); ++m)
    all_of(quantity.methods_in_float[m], result.in_float[m].trials);
  for (std::size_t b = 0; b < quantity.breakdowns.size(); ++b) {
    const Breakdown& breakdown = quantity.breakdowns[b];
    BreakdownResult& place = result.breakdowns[b];
    Unfilled& unfilled = work.unfilled.emplace_back(Unfilled{&quantity, &breakdown, &place});
    work.pending.push_back({&quantity, &method_named(quantity, breakdown.method), breakdown.setting,
                            &place.broken, &unfilled.broken});
    work.pending.push_back({&quantity, &method_named(quantity, breakdown.cure), breakdown.cure_setting,
                            &place.cured, &unfilled.cured});
  }
  return result;
}

/// Sets where a reader of the manual finds the claims: at their line, or at the first of their assertions.
void place(std::vector<JudgedClaim>& claims, const std::vector<Assertion>& ledger) {
  for (JudgedClaim& judged : claims)
    for (const Assertion& assertion : ledger) {
      if (std::ranges::find(assertion.claims, judged.claim.id) == assertion.claims.end()) continue;
      const bool its_line = assertion.line == judged.claim.line;
      if (its_line || judged.claim.place.empty()) judged.claim.place = assertion.place;
      if (its_line) break;
    }
}

ExerciseResult shape(const Studied& studied, const Reference& truth, Work& work) {
  const Entry& entry = *studied.task->entry;
  ExerciseResult result{entry.number,
                        std::string(entry.exercise.title),
                        std::string(entry.exercise.asks),
                        entry.exercise.scene.has_value(),
                        {},
                        {},
                        {},
                        studied.failure};
  for (const Parameter& p : entry.exercise.parameters)
    result.parameters.push_back(
        {std::string(p.name), studied.task->parameters[p.name], std::string(p.unit), std::string(p.says)});
  for (const Claim& claim : studied.findings.claims) result.claims.push_back({claim, verdict(claim)});
  place(result.claims, read_ledger(truth.folder(), to_string(entry.number)));
  result.roots = studied.findings.roots;
  result.verdict = studied.findings.verdict;
  try {
    if (result.failure.empty()) static_cast<void>(verdict_of(result));
  } catch (const std::logic_error& error) {
    result.failure = error.what();
  }
  for (const Quantity& quantity : studied.findings.quantities)
    result.quantities.push_back(shape(quantity, *studied.task, work));
  return result;
}

/// The truth of a kicked motion is one of its methods' own: no error is below the truth's.
void bound_errors(QuantityResult& kicked) {
  for (MethodResult& method : kicked.methods)
    for (TimedTrial& trial : method.trials) trial.error = std::max(trial.error, kicked.reference_error);
}

/// Adds the paths of a scene's motion to the quantity that its study made of it.
void see_motion(const Task& task, ExerciseResult& result) {
  const auto& scene = task.entry->exercise.scene;
  if (!scene) return;
  const std::string name = scene->motion(task.parameters, {scene->horizon}, Reference::nothing()).name;
  for (QuantityResult& q : result.quantities)
    if (q.name == name) q.trajectory = trajectory(*scene, task.parameters, q);
}

}  // namespace

const Method* method_of(const Quantity& quantity, std::string_view model, std::string_view algorithm) {
  for (const auto* methods : {&quantity.methods, &quantity.methods_in_float})
    for (const Method& m : *methods)
      if (m.model == model && m.algorithm == algorithm) return &m;
  return nullptr;
}

TimedTrial as_result(const Trial& trial) {
  const Answer& answer = trial.answer;
  return {trial.model,
          trial.algorithm,
          trial.resolution,
          trial.setting,
          answer.value,
          trial.error,
          trial.final_error,
          answer.error_estimate,
          answer.drift,
          answer.evaluations,
          trial.outcome,
          answer.message,
          {},
          trial.precision,
          0,
          answer.comes_back};
}

bool as_accurate_as_roundings_allow(const TimedTrial& in_float, const TimedTrial& in_double) {
  if (in_double.outcome != Outcome::ok && in_double.outcome != Outcome::inaccurate) return true;
  return in_float.error <= 2 * in_double.error + in_float.roundings;
}

Results run(std::span<const Task> tasks, const Reference& truth, bool timed, const Progress& progress) {
  std::vector<Studied> studied(tasks.size());
  for (std::size_t i = 0; i < tasks.size(); ++i) studied[i].task = &tasks[i];
  {
    Stage tally(progress, "studying the exercises", tasks.size());
    parallel_for_each(studied, [&](Studied& s) {
      s = study(*s.task, truth);
      tally.add();
    });
  }
  Results results;
  Work work;
  const auto& pending = work.pending;
  for (const Studied& s : studied) results.exercises.push_back(shape(s, truth, work));

  Stage tally(progress, timed ? "running and timing the trials" : "running the trials",
              pending.size() * (timed ? 2 : 1));
  parallel_for_each(pending, [&](const Pending& p) {
    Trial trial = run(*p.quantity, *p.method, p.setting);
    *p.result = as_result(trial);
    if (p.kept != nullptr) *p.kept = std::move(trial);
    if (p.method->roundings) p.result->roundings = p.method->roundings(p.setting);
    tally.add();
  });
  for (std::size_t i = 0; i < tasks.size(); ++i)
    if (tasks[i].kicks) std::ranges::for_each(results.exercises[i].quantities, bound_errors);
  for (const Unfilled& u : work.unfilled)
    u.result->says = text_of(*u.breakdown, *u.quantity, u.broken, u.cured);
  std::vector<std::size_t> places(tasks.size());
  std::iota(places.begin(), places.end(), 0);
  parallel_for_each(places, [&](std::size_t i) {
    ExerciseResult& e = results.exercises[i];
    if (e.failure.empty()) e.failure = failure_of([&] { see_motion(tasks[i], e); });
  });
  if (!timed) return results;
  results.seam = seam();
  for (const Pending& p : pending) {
    if (p.result->value.size() > 0) p.result->time = time(*p.method, p.setting);
    tally.add();
  }
  return results;
}

}  // namespace oddity
