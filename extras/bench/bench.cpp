#include "extras/bench/bench.hpp"

#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "extras/bench/fresh_pages.hpp"
#include "extras/bench/instructions.hpp"
#include "reference/text.hpp"
#include "report/charts/labels.hpp"
#include "report/study/time.hpp"
#include "report/text/table_text.hpp"

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

/// Seconds per run. Both sides of a comparison run in turn, each first in half of the batches.
constexpr double batch_seconds = 3e-4;

template <class F>
int runs_a_batch(const F& f) {
  return static_cast<int>(std::ceil(batch_seconds / std::max(seconds(f), 1e-6)));
}

template <class F>
double batch(const F& f, int runs) {
  return seconds([&] {
           for (int i = 0; i < runs; ++i) static_cast<void>(f());
         }) /
         runs;
}

// ---- races ------------------------------------------------------------------------------------------------

/// One side of a race: seconds per right-hand side of each batch.
struct Side {
  const std::function<Run()>& run;
  Run once = run();
  int runs = runs_a_batch(run);
  std::vector<double> seconds = {}, instructions = {};

  void measure(const Instructions& counter) {
    const double before = counter.now();
    const auto evaluations = static_cast<double>(once.evaluations);
    seconds.push_back(batch(run, runs) / evaluations);
    instructions.push_back((counter.now() - before) / (evaluations * runs));
  }
};

struct Timed {
  const Race& race;
  Side by_hand{race.by_hand}, inlined{race.inlined}, precompiled{race.precompiled};
  std::vector<double> ratios = {};

  void measure(const Instructions& counter) {
    const bool hand_first = ratios.size() % 2 == 0;
    (hand_first ? by_hand : inlined).measure(counter);
    (hand_first ? inlined : by_hand).measure(counter);
    precompiled.measure(counter);
    ratios.push_back(inlined.seconds.back() / by_hand.seconds.back());
  }
  RaceResult result() const {
    return {race.model,
            race.states,
            race.algorithm,
            race.limit,
            spread_of(by_hand.seconds),
            spread_of(inlined.seconds),
            spread_of(precompiled.seconds),
            spread_of(ratios),
            spread_of(by_hand.instructions).median,
            spread_of(inlined.instructions).median,
            distance(by_hand.once.state, inlined.once.state)};
  }
};

// ---- contests ---------------------------------------------------------------------------------------------

/// The coarsest setting at which, and at all finer ones, error(setting) meets the tolerance; NaN if none
/// does.
template <class Error>
double coarsest(const Method& method, double need, const Error& error) {
  double found = std::numeric_limits<double>::quiet_NaN();
  for (auto setting = method.resolution.settings.rbegin(); setting != method.resolution.settings.rend();
       ++setting) {
    if (!(error(*setting) <= need)) break;
    found = *setting;
  }
  return found;
}

/// Time per piece of `work`, also in units of one right-hand side by hand, measured in turn with it.
template <class Work>
void time_in_units(Entrant& entrant, const Race& hand, const Work& work, double pieces) {
  constexpr int batches = 200;
  const auto evaluations = static_cast<double>(hand.by_hand().evaluations);
  const int runs = runs_a_batch(work), hand_runs = runs_a_batch(hand.by_hand);
  std::vector<double> times, units;
  for (int b = 0; b < batches; ++b) {
    double unit = b % 2 ? 0 : batch(hand.by_hand, hand_runs);
    times.push_back(batch(work, runs) / pieces);
    if (b % 2) unit = batch(hand.by_hand, hand_runs);
    units.push_back(times.back() / (unit / evaluations));
  }
  entrant.seconds = spread_of(times);
  entrant.units = spread_of(units);
}

/// The cheapest of all methods, each at the coarsest setting whose error meets the tolerance.
template <class Error>
Entrant cheapest(const Contest& contest, const Race& hand, const Error& error) {
  Entrant best{"none", 0, 0, 0, 0, {}, {std::numeric_limits<double>::infinity(), 0}};
  double least = std::numeric_limits<double>::infinity();
  const Method* chosen = nullptr;
  for (std::size_t m = 0; m < contest.to_end.methods.size(); ++m) {
    const Method& method = contest.to_end.methods[m];
    const double setting =
        coarsest(method, contest.to_end.need.allowed, [&](double s) { return error(m, s); });
    if (!std::isfinite(setting)) continue;
    const double time = oddity::time(method, setting).seconds;
    if (time >= least) continue;
    const Trial end = run(contest.to_end, method, setting);
    const Trial through = run(contest.through, contest.through.methods[m], setting);
    least = time;
    chosen = &method;
    best.method = method.algorithm + ", " + method.resolution.name + " " + format_significant(setting, 2);
    best.setting = setting;
    best.evaluations = end.answer.evaluations;
    best.final_error = end.error;
    best.worst_error = std::max(end.error, through.error);
  }
  if (chosen)
    time_in_units(
        best, hand, [&] { return chosen->run(best.setting); }, 1);
  return best;
}

/// One evaluation of the closed form: timed at a thousand times of the motion, judged at the known ones.
Entrant closed_form(const Contest& contest, const Race& hand) {
  constexpr int count = 1000;
  Entrant entrant{contest.closed_form, 0, 1, 0, 0, {}, {}};
  volatile double sum = 0;
  const auto all = [&] {
    for (int i = 1; i <= count; ++i) sum = sum + contest.at(contest.end * i / count);
  };
  time_in_units(entrant, hand, all, count);
  const Value& known = contest.through.reference.value;
  const int samples = contest.through.samples;
  const std::size_t observables = known.size() / static_cast<std::size_t>(samples);
  for (int i = 1; i <= samples; ++i) {
    entrant.final_error = std::abs(contest.at(contest.end * i / samples) -
                                   known[static_cast<std::size_t>(i - 1) * observables]);
    entrant.worst_error = std::max(entrant.worst_error, entrant.final_error);
  }
  return entrant;
}

// ---- the suite --------------------------------------------------------------------------------------------

/// Does the work of run(), one piece after the other.
ExerciseTime time_exercise(const Entry& entry, const Reference& truth) {
  ExerciseTime result{to_string(entry.number), std::string(entry.exercise.title), 0, 0, 0, ""};
  Findings findings;
  result.studying =
      seconds([&] { findings = entry.exercise.study(Parameters(entry.exercise.parameters), truth); });
  for (const Quantity& quantity : findings.quantities)
    for (const Method& method : quantity.methods)
      for (double setting : method.resolution.settings) {
        const double time = seconds([&] { static_cast<void>(run(quantity, method, setting)); });
        result.trials += time;
        if (time <= result.longest_trial) continue;
        result.longest_trial = time;
        result.longest = quantity.name + ": " + method.model + ", " + method.algorithm + " at " +
                         format_significant(setting, 3);
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

std::string_view verdict_of(const Bound& limit) {
  return limit.holds() ? "holds" : limit.broken() ? "BROKEN" : "undecided";
}

std::string limit_text(const Bound& limit, int decimals, const Screen& screen) {
  const Style style = limit.holds() ? Style::good : limit.broken() ? Style::bad : Style::doubtful;
  return fixed(limit.at_most, decimals) + ", " + screen.styled(style, std::string(verdict_of(limit)));
}

std::string races_text(const Bench& bench, const Screen& screen) {
  Rows rows{{"model", "states", "algorithm", "by hand", "inlined", "ratio", "+-", "at most", "instructions",
             "difference", "precompiled"}};
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const RaceResult& r : bench.races) {
    const double instructions = r.instructions_inlined / r.instructions_by_hand;
    rows.push_back({r.model, std::to_string(r.states), r.algorithm, shown_time(r.by_hand.median),
                    shown_time(r.inlined.median), fixed(r.ratio.median, 3), fixed(r.ratio.half_width, 3),
                    r.at_most > 0 ? limit_text(r.bound(), 2, screen) : "-", fixed(instructions, 3),
                    r.difference == 0 ? "0" : shown_error(r.difference), shown_time(r.precompiled.median)});
    const double longer = r.precompiled.median - r.inlined.median;
    least = std::min(least, longer), most = std::max(most, longer);
  }
  return wrapped(
             "The integrators against loops written by hand: time of one right-hand side, medians of batches "
             "in turn\n(inlined: compiled into the model; precompiled: as the scenes run it, the model behind "
             "a virtual call)\n",
             screen) +
         aligned(rows, screen,
                 {{"model", "algorithm"},
                  {"instructions", "states", "difference", "precompiled", "inlined", "by hand"}}) +
         wrapped(
             "  Precompiled, a right-hand side takes " + fixed(1e9 * least, 1) + " to " +
                 fixed(1e9 * most, 1) + " ns longer than inlined.\n" +
                 (bench.no_instructions.empty()
                      ? ""
                      : "  Instructions are not counted on this machine: " + bench.no_instructions + ".\n"),
             screen, 4);
}

std::vector<std::string> entrant_row(const std::string& what, const Entrant& e, const std::string& limit) {
  const int decimals = e.units.median < 100 ? 1 : 0;
  return {what,
          e.method,
          std::to_string(e.evaluations),
          shown_error(e.final_error),
          shown_error(e.worst_error),
          shown_time(e.seconds.median),
          fixed(e.units.median, decimals),
          fixed(e.units.half_width, decimals),
          limit};
}

std::string contest_text(const ContestResult& c, const Screen& screen) {
  Rows rows{{"judged by", "cheapest method", "evals", "final error", "worst error", "time", "units", "+-",
             "at most"}};
  rows.push_back(entrant_row("error at the end", c.at_end, limit_text(c.bound(), 0, screen)));
  rows.push_back(entrant_row("worst error on the way", c.throughout, "-"));
  rows.push_back(entrant_row("", c.closed_form, limit_text(c.closed_bound(), 0, screen)));
  return wrapped("\n" + c.says + ", to " + shown_error(c.need) + "; one unit is a right-hand side by hand, " +
                     shown_time(c.unit_seconds) +
                     "\n(integrated straight to the end; the worst error also on the same method stopped at "
                     "many times)\n",
                 screen) +
         aligned(rows, screen,
                 {{"judged by", "cheapest method"}, {"evals", "time", "final error", "worst error", "+-"}});
}

std::string suite_text(const SuiteTime& suite, const Screen& screen) {
  std::vector<ExerciseTime> sorted = suite.exercises;
  std::ranges::sort(sorted, std::greater(), [](const ExerciseTime& e) { return e.studying + e.trials; });
  Rows rows{{"exercise", "studying", "trials", "longest trial", ""}};
  for (const ExerciseTime& e : sorted)
    rows.push_back(
        {e.number, shown_time(e.studying), shown_time(e.trials), shown_time(e.longest_trial), e.longest});
  return "\nThe suite at default parameters, each exercise alone on one thread\n" +
         aligned(rows, screen, {{""}, {"studying"}}) +
         wrapped("  critical path (the longest study, then the longest trial) " +
                     shown_time(suite.critical_path()) + "\n  all: one thread " +
                     shown_time(suite.one_thread) + ", two threads " + shown_time(suite.two_threads.median) +
                     " +- " + shown_time(suite.two_threads.half_width) + ", speed-up " +
                     fixed(suite.speed_up(), 2) + "; at most " + limit_text(suite.bound(), 0, screen) + "\n",
                 screen, 4);
}

Bound slope_of(const ChainBench& bench) {
  return {"the slope of a chain's cost", spread_of(bench.slopes), 1.05};
}

std::string chains_text(const ChainBench& bench, const Screen& screen) {
  if (bench.chains.empty()) return "";
  Rows rows{{"links", "tensions", "a link", "dense matrix", "bytes a link", "stable to", "theory"}};
  for (const ChainResult& c : bench.chains)
    rows.push_back({std::to_string(c.links), shown_time(c.tensions), shown_time(c.tensions / c.links),
                    std::isfinite(c.dense) ? shown_time(c.dense) : "-", fixed(c.bytes / c.links, 0),
                    format_significant(c.stable, 3) + " s", format_significant(c.theory, 3) + " s"});
  const Bound slope = slope_of(bench);
  return wrapped(
             "\nChains of n links of 1 m: time of the accelerations by the rods' tensions and by the dense "
             "matrix. Also the largest step of Runge-Kutta 4 at which no small oscillation grows. Theory: "
             "sqrt(8 r/(g z)), z the largest zero of the Laguerre polynomial of degree n\n",
             screen) +
         aligned(rows, screen, {{"links"}, {"tensions"}}) +
         wrapped("  The time by the tensions grows as the links to the power " +
                     fixed(slope.measured.median, 3) + " +- " + fixed(slope.measured.half_width, 3) +
                     "; at most " + limit_text(slope, 2, screen) + "\n",
                 screen, 4);
}

/// Reports whether all limits hold, and lists those that do not.
std::string verdict_text(const std::vector<Bound>& limits) {
  std::string not_held;
  for (const Bound& l : limits)
    if (!l.holds())
      not_held += (not_held.empty() ? " " : "; ") + l.says + " (" + std::string(verdict_of(l)) + ")";
  const auto held = std::ranges::count_if(limits, &Bound::holds);
  return "\n" + std::to_string(held) + " of " + std::to_string(limits.size()) + " limits hold" +
         (not_held.empty() ? "." : "; not:" + not_held + ".") + "\n";
}

}  // namespace

Spread spread_of(std::vector<double> measured) {
  std::ranges::sort(measured);
  const std::size_t n = measured.size();
  return {measured[n / 2], (measured[(3 * n) / 4] - measured[n / 4]) / 2};
}

std::vector<RaceResult> race(const std::vector<Race>& races, const Progress& progress) {
  constexpr int rounds = 10, batches = 30;
  const Instructions counter;
  std::vector<Timed> all;
  for (const Race& r : races) all.push_back({r});
  for (int round = 0; round < rounds; ++round) {
    if (progress) progress("racing the integrators", round, rounds);
    move_code_to_fresh_pages();
    for (Timed& timed : all)
      for (int b = 0; b < batches; ++b) timed.measure(counter);
  }
  std::vector<RaceResult> results;
  for (const Timed& timed : all) results.push_back(timed.result());
  return results;
}

ContestResult compete(const Contest& contest, const Race& hand) {
  const auto final_error = [&](std::size_t m, double setting) {
    return run(contest.to_end, contest.to_end.methods[m], setting).error;
  };
  const auto worst_error = [&](std::size_t m, double setting) {
    return run(contest.through, contest.through.methods[m], setting).error;
  };
  const Entrant at_end = cheapest(contest, hand, final_error);
  return {contest.says,
          contest.hand,
          contest.to_end.need.allowed,
          at_end.seconds.median / at_end.units.median,
          at_end,
          cheapest(contest, hand, worst_error),
          contest.limit,
          closed_form(contest, hand),
          contest.closed_limit};
}

double SuiteTime::critical_path() const {
  double study = 0, trial = 0;
  for (const ExerciseTime& e : exercises) {
    study = std::max(study, e.studying);
    trial = std::max(trial, e.longest_trial);
  }
  return study + trial;
}

Bound SuiteTime::bound() const { return {"the suite on two threads", two_threads, most_seconds}; }

SuiteTime time_suite(const Reference& truth, const Progress& progress) {
  constexpr std::size_t whole_runs = 4;
  const auto tell = [&](std::size_t runs) {
    if (progress) progress("timing the whole suite", static_cast<double>(runs), whole_runs);
  };
  tell(0);
  SuiteTime suite{{}, suite_seconds(truth, 1), {}};
  std::vector<double> two_threads;
  while (two_threads.size() + 1 < whole_runs) {
    tell(1 + two_threads.size());
    two_threads.push_back(suite_seconds(truth, 2));
  }
  suite.two_threads = spread_of(two_threads);
  for (const Entry& entry : registry()) {
    if (progress)
      progress("timing each exercise", static_cast<double>(suite.exercises.size()), registry().size());
    suite.exercises.push_back(time_exercise(entry, truth));
  }
  return suite;
}

std::vector<Bound> Bench::bounds() const {
  std::vector<Bound> all;
  for (const RaceResult& r : races)
    if (r.at_most > 0) all.push_back(r.bound());
  for (const ContestResult& c : contests) all.push_back(c.bound()), all.push_back(c.closed_bound());
  all.push_back(suite.bound());
  if (!chains.slopes.empty()) all.push_back(slope_of(chains));
  return all;
}

bool Bench::broken() const { return std::ranges::any_of(bounds(), &Bound::broken); }

Bench bench(const Reference& truth, const Progress& progress) {
  const std::vector<Race> all = races();
  Bench result{Instructions().why_not(), race(all, progress), {}, {}};
  const std::vector<Contest> problems = contests(truth);
  for (const Contest& contest : problems) {
    if (progress)
      progress("looking for the best methods", static_cast<double>(result.contests.size()), problems.size());
    const auto hand = std::ranges::find_if(
        all, [&](const Race& r) { return r.model == contest.hand && r.algorithm == "Runge-Kutta 4"; });
    result.contests.push_back(compete(contest, *hand));
  }
  result.series = race_series(truth, progress);
  result.chains = bench_chains(progress);
  result.suite = time_suite(truth, progress);
  return result;
}

std::string bench_view(const Bench& bench, const Screen& screen) {
  std::string text = races_text(bench, screen);
  for (const ContestResult& c : bench.contests) text += contest_text(c, screen);
  text += series_text(bench.series, screen) + chains_text(bench.chains, screen);
  return text + suite_text(bench.suite, screen) + wrapped(verdict_text(bench.bounds()), screen);
}

Table bench_table(const Bench& bench) {
  Table table{{"part", "subject", "measured", "value", "half_width", "unit", "at_most", "verdict"}, {}};
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const auto add = [&](const char* part, const std::string& subject, const std::string& measured,
                       const Spread& spread, const char* unit, const Bound* bound = nullptr) {
    table.rows.push_back({part, subject, measured, spread.median, spread.half_width, unit,
                          bound ? bound->at_most : none, bound ? std::string(verdict_of(*bound)) : ""});
  };
  for (const RaceResult& r : bench.races) {
    const Bound bound = r.bound();
    add("race", bound.says, "by hand", r.by_hand, "s");
    add("race", bound.says, "inlined", r.inlined, "s");
    add("race", bound.says, "precompiled", r.precompiled, "s");
    add("race", bound.says, "ratio", r.ratio, "1", r.at_most > 0 ? &bound : nullptr);
  }
  for (const ContestResult& c : bench.contests) {
    const Bound end = c.bound(), closed = c.closed_bound();
    add("contest", c.says, "error at the end by " + c.at_end.method, c.at_end.units, "right-hand sides",
        &end);
    add("contest", c.says, "worst error by " + c.throughout.method, c.throughout.units, "right-hand sides");
    add("contest", c.says, c.closed_form.method, c.closed_form.units, "right-hand sides", &closed);
  }
  for (const ExerciseTime& e : bench.suite.exercises) {
    add("suite", e.number, "studying", {e.studying, none}, "s");
    add("suite", e.number, "trials", {e.trials, none}, "s");
    add("suite", e.number, "longest trial", {e.longest_trial, none}, "s");
  }
  for (const SeriesRace& r : bench.series)
    add("series", r.scene, "time over the fastest other's, to 1e-12", {r.ratio, r.half_width}, "1");
  for (const ChainResult& c : bench.chains.chains) {
    const std::string links = std::to_string(c.links) + " links";
    add("chain", links, "accelerations by the tensions", {c.tensions, none}, "s");
    if (std::isfinite(c.dense))
      add("chain", links, "accelerations by the dense matrix", {c.dense, none}, "s");
    add("chain", links, "largest stable step", {c.stable, none}, "s");
    add("chain", links, "largest stable step by theory", {c.theory, none}, "s");
  }
  if (!bench.chains.slopes.empty()) {
    const Bound slope = slope_of(bench.chains);
    add("chain", "all", "slope of the cost", slope.measured, "1", &slope);
  }
  const Bound suite = bench.suite.bound();
  add("suite", "all", "one thread", {bench.suite.one_thread, none}, "s");
  add("suite", "all", "two threads", bench.suite.two_threads, "s", &suite);
  return table;
}

}  // namespace oddity
