#include "report/bench.hpp"

#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "reference/text.hpp"
#include "report/instructions.hpp"
#include "report/text_view.hpp"
#include "report/time.hpp"

namespace oddity {

namespace {

constexpr double most_seconds = 10;  // for the whole suite

using Clock = std::chrono::steady_clock;

template <class F>
double seconds(const F& f) {
  const auto start = Clock::now();
  f();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// ---- races ------------------------------------------------------------------------------------------------

/// Seconds and instructions of `runs` runs, a right-hand side.
struct Batch {
  double seconds, instructions;
};

Batch batch(const std::function<Run()>& f, long evaluations, int runs, const Instructions& counter) {
  const double before = counter.now();
  const double time = seconds([&] {
    for (int i = 0; i < runs; ++i) static_cast<void>(f());
  });
  const double work = static_cast<double>(evaluations) * runs;
  return {time / work, (counter.now() - before) / work};
}

RaceResult race(const Race& race, const Instructions& counter) {
  constexpr int batches = 100;
  constexpr double batch_seconds = 3e-4;
  const Run hand = race.by_hand(), integrated = race.inlined();
  const int runs = static_cast<int>(
      std::ceil(batch_seconds / std::max(seconds([&] { static_cast<void>(race.by_hand()); }), 1e-6)));
  std::vector<double> hand_times, inlined_times, precompiled_times, ratios, hand_counts, inlined_counts;
  for (int b = 0; b < batches; ++b) {  // in turn, each side first in half of the batches
    const auto by_hand = [&] { return batch(race.by_hand, hand.evaluations, runs, counter); };
    Batch first = b % 2 ? Batch{} : by_hand();
    const Batch second = batch(race.inlined, integrated.evaluations, runs, counter);
    if (b % 2) first = by_hand();
    hand_times.push_back(first.seconds), hand_counts.push_back(first.instructions);
    inlined_times.push_back(second.seconds), inlined_counts.push_back(second.instructions);
    precompiled_times.push_back(batch(race.precompiled, integrated.evaluations, runs, counter).seconds);
    ratios.push_back(second.seconds / first.seconds);
  }
  return {race.model,
          race.states,
          race.algorithm,
          race.limit,
          spread_of(hand_times),
          spread_of(inlined_times),
          spread_of(precompiled_times),
          spread_of(ratios),
          spread_of(hand_counts).median,
          spread_of(inlined_counts).median,
          distance(hand.state, integrated.state)};
}

// ---- contests ---------------------------------------------------------------------------------------------

/// A setting from which on, to the finest, error(setting) meets the need; NaN: there is none.
template <class Error>
double coarsest(const Method& method, double need, const Error& error) {
  double found = std::numeric_limits<double>::quiet_NaN();
  for (auto setting = method.knob.settings.rbegin(); setting != method.knob.settings.rend(); ++setting) {
    if (!(error(*setting) <= need)) break;
    found = *setting;
  }
  return found;
}

/// The cheapest of all methods, each at the coarsest setting whose error meets the need.
template <class Error>
Entrant cheapest(const Contest& contest, double unit_seconds, const Error& error) {
  Entrant best{"none", 0, 0, 0, 0, {}, std::numeric_limits<double>::infinity()};
  for (std::size_t m = 0; m < contest.to_end.methods.size(); ++m) {
    const Method& method = contest.to_end.methods[m];
    const double setting =
        coarsest(method, contest.to_end.need.allowed, [&](double s) { return error(m, s); });
    if (!std::isfinite(setting)) continue;
    const Trial end = run(contest.to_end, method, setting);
    const Trial through = run(contest.through, contest.through.methods[m], setting);
    const Time time = oddity::time(method, setting);
    const double units = time.seconds / unit_seconds;
    if (units < best.units)
      best = {method.algorithm + ", " + method.knob.name + " " + rounded(setting, 2),
              setting,
              end.answer.evaluations,
              end.error,
              std::max(end.error, through.error),
              time,
              units};
  }
  return best;
}

/// One evaluation of the closed form, at a thousand times over the motion.
Time time_closed_form(const Contest& contest) {
  constexpr int count = 1000;
  const Method all{"", "", no_knob(), [&](double) {
                     double sum = 0;
                     for (int i = 1; i <= count; ++i) sum += contest.at(contest.end * i / count);
                     return Answer{sum, count};
                   }};
  const Time time = oddity::time(all, 0);
  return {time.seconds / count, time.spread / count};
}

// ---- the suite --------------------------------------------------------------------------------------------

/// The work of run(), one piece after the other.
ExerciseTime time_exercise(const Entry& entry, const Reference& truth) {
  ExerciseTime result{to_string(entry.number), std::string(entry.exercise.title), 0, 0, 0, ""};
  Findings findings;
  result.studying =
      seconds([&] { findings = entry.exercise.study(Parameters(entry.exercise.parameters), truth); });
  for (const Quantity& quantity : findings.quantities)
    for (const Method& method : quantity.methods)
      for (double setting : method.knob.settings) {
        const double time = seconds([&] { static_cast<void>(run(quantity, method, setting)); });
        result.trials += time;
        if (time <= result.longest_trial) continue;
        result.longest_trial = time;
        result.longest =
            quantity.name + ": " + method.model + ", " + method.algorithm + " at " + rounded(setting, 3);
      }
  return result;
}

double suite_seconds(const Reference& truth, std::size_t threads) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  const std::vector<Task> tasks(registry().begin(), registry().end());
  return seconds([&] { static_cast<void>(run(tasks, truth, false)); });
}

// ---- the view ---------------------------------------------------------------------------------------------

using Rows = std::vector<std::vector<std::string>>;

std::string fixed(double x, int decimals) {
  if (!std::isfinite(x)) return "-";
  char buffer[400];  // the largest double has 309 digits before the point
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::fixed, decimals).ptr};
}

std::string limit_text(double limit, int decimals, bool holds) {
  return fixed(limit, decimals) + (holds ? ", holds" : ", BROKEN");
}

std::string races_text(const Bench& bench) {
  Rows rows{{"model", "states", "algorithm", "by hand", "inlined", "ratio", "+-", "at most", "instructions",
             "difference", "precompiled"}};
  for (const RaceResult& r : bench.races) {
    const double instructions = r.instructions_inlined / r.instructions_by_hand;
    rows.push_back({r.model, std::to_string(r.states), r.algorithm, shown_time(r.by_hand.median),
                    shown_time(r.inlined.median), fixed(r.ratio.median, 3), fixed(r.ratio.half_width, 3),
                    r.limit > 0 ? limit_text(r.limit, 2, r.holds()) : "-", fixed(instructions, 3),
                    r.difference == 0 ? "0" : shown_error(r.difference), shown_time(r.precompiled.median)});
  }
  return "The integrators against loops written by hand: time of one right-hand side, medians of batches in "
         "turn\n(inlined: compiled into the model; precompiled: as the scenes run it, the model behind a "
         "virtual call)\n" +
         aligned(rows) +
         (bench.no_instructions.empty()
              ? ""
              : "  Instructions are not counted on this machine: " + bench.no_instructions + ".\n");
}

std::vector<std::string> entrant_row(const std::string& what, const Entrant& e, const std::string& limit) {
  return {what,
          e.method,
          std::to_string(e.evaluations),
          shown_error(e.final_error),
          shown_error(e.worst_error),
          shown_time(e.time.seconds),
          fixed(e.units, 0),
          limit};
}

std::string contest_text(const ContestResult& c) {
  Rows rows{
      {"judged by", "cheapest method", "evals", "final error", "worst error", "time", "units", "at most"}};
  rows.push_back(
      entrant_row("error at the end", c.at_end, limit_text(c.limit, 0, c.at_end.units <= c.limit)));
  rows.push_back(entrant_row("worst error on the way", c.throughout, "-"));
  rows.push_back({"", c.closed_form, "1", shown_error(c.closed_final_error),
                  shown_error(c.closed_worst_error), shown_time(c.closed_time.seconds),
                  fixed(c.closed_units, 1), limit_text(c.closed_limit, 0, c.closed_units <= c.closed_limit)});
  return "\n" + c.says + ", to " + shown_error(c.need) + "; one unit is a right-hand side by hand, " +
         shown_time(c.unit_seconds) +
         "\n(integrated straight to the end; the worst error also on the same method stopped at many "
         "times)\n" +
         aligned(rows);
}

std::string suite_text(const SuiteTime& suite) {
  std::vector<ExerciseTime> sorted = suite.exercises;
  std::ranges::sort(sorted, std::greater(), [](const ExerciseTime& e) { return e.studying + e.trials; });
  Rows rows{{"exercise", "studying", "trials", "longest trial", ""}};
  for (const ExerciseTime& e : sorted)
    rows.push_back(
        {e.number, shown_time(e.studying), shown_time(e.trials), shown_time(e.longest_trial), e.longest});
  return "\nThe suite at default parameters, each exercise alone on one thread\n" + aligned(rows) +
         "  critical path (the longest study, then the longest trial) " + shown_time(suite.critical_path()) +
         "\n  all: one thread " + shown_time(suite.one_thread) + ", two threads " +
         shown_time(suite.two_threads) + ", speed-up " + fixed(suite.speed_up(), 2) + "; at most " +
         limit_text(most_seconds, 0, suite.two_threads <= most_seconds) + "\n";
}

}  // namespace

Spread spread_of(std::vector<double> measured) {
  std::ranges::sort(measured);
  const std::size_t n = measured.size();
  return {measured[n / 2], (measured[(3 * n) / 4] - measured[n / 4]) / 2};
}

std::vector<RaceResult> race(const std::vector<Race>& races) {
  const Instructions counter;
  std::vector<RaceResult> results;
  for (const Race& r : races) results.push_back(race(r, counter));
  return results;
}

ContestResult compete(const Contest& contest, double unit_seconds) {
  const auto final_error = [&](std::size_t m, double setting) {
    return run(contest.to_end, contest.to_end.methods[m], setting).error;
  };
  const auto worst_error = [&](std::size_t m, double setting) {
    return run(contest.through, contest.through.methods[m], setting).error;
  };
  const Time closed = time_closed_form(contest);
  const Value& known = contest.through.reference.value;
  const int samples = contest.through.samples;
  const std::size_t observables = known.size() / static_cast<std::size_t>(samples);
  double error = 0, worst = 0;
  for (int i = 1; i <= samples; ++i) {
    error = std::abs(contest.at(contest.end * i / samples) -
                     known[static_cast<std::size_t>(i - 1) * observables]);
    worst = std::max(worst, error);
  }
  return {contest.says,
          contest.hand,
          contest.to_end.need.allowed,
          unit_seconds,
          cheapest(contest, unit_seconds, final_error),
          cheapest(contest, unit_seconds, worst_error),
          contest.limit,
          contest.closed_form,
          closed,
          closed.seconds / unit_seconds,
          contest.closed_limit,
          error,
          worst};
}

double SuiteTime::critical_path() const {
  double study = 0, trial = 0;
  for (const ExerciseTime& e : exercises) {
    study = std::max(study, e.studying);
    trial = std::max(trial, e.longest_trial);
  }
  return study + trial;
}

SuiteTime time_suite(const Reference& truth, const Progress& progress) {
  SuiteTime suite{{}, suite_seconds(truth, 1), suite_seconds(truth, 2)};
  for (const Entry& entry : registry()) {
    suite.exercises.push_back(time_exercise(entry, truth));
    if (progress) progress("timing the suite", suite.exercises.size(), registry().size());
  }
  return suite;
}

Bench bench(const Reference& truth, const Progress& progress) {
  Bench result{Instructions().why_not(), race(races()), {}, {}};
  for (const Contest& contest : contests(truth)) {
    const auto unit = std::ranges::find_if(result.races, [&](const RaceResult& r) {
      return r.model == contest.hand && r.algorithm == "Runge-Kutta 4";
    });
    result.contests.push_back(compete(contest, unit->by_hand.median));
  }
  result.suite = time_suite(truth, progress);
  return result;
}

std::string bench_view(const Bench& bench) {
  std::string text = races_text(bench);
  for (const ContestResult& c : bench.contests) text += contest_text(c);
  return text + suite_text(bench.suite);
}

}  // namespace oddity
