#pragma once

#include <string>
#include <vector>

#include "extras/bench/chain.hpp"
#include "extras/bench/loops.hpp"
#include "extras/bench/series.hpp"
#include "report/study/run.hpp"
#include "report/text/table_text.hpp"

/// How fast this build is on this machine, in this run: the integrators against loops written by hand, the
/// best methods of two problems in units of a right-hand side written by hand, and the whole suite.
namespace oddity {

/// The median of many measurements, and half their interquartile range.
struct Spread {
  double median, half_width;
};
Spread spread_of(std::vector<double> measured);

/// A measured number and its limit. Noise decides nothing: it holds, or is broken, when it is on that
/// side of the limit by more than its spread.
struct Bound {
  std::string says;
  Spread measured;
  double at_most;

  bool holds() const { return measured.median + measured.half_width <= at_most; }
  bool broken() const { return measured.median - measured.half_width > at_most; }
};

/// A race as it was run: seconds and instructions a right-hand side; instructions are NaN where the machine
/// counts none.
struct RaceResult {
  std::string model;
  int states;
  std::string algorithm;
  double at_most;  ///< for the ratio; 0: there is no limit
  Spread by_hand, inlined, precompiled;
  Spread ratio;  ///< of inlined to by hand
  double instructions_by_hand, instructions_inlined;
  double difference;  ///< the largest, between the two final states

  Bound bound() const { return {model + " by " + algorithm, ratio, at_most}; }
};

/// Runs all sides in turn, in several rounds of all races, in batches of a fraction of a millisecond.
std::vector<RaceResult> race(const std::vector<Race>&, const Progress& progress = {});

/// A method that meets the need of a contest.
struct Entrant {
  std::string method;
  double setting;
  long evaluations;
  double final_error, worst_error;
  Spread seconds;
  Spread units;  ///< its time over that of one right-hand side written by hand, measured in turn
};

struct ContestResult {
  std::string says, hand;
  double need, unit_seconds;
  Entrant at_end;      ///< the cheapest whose error at the end meets the need, at this and each finer setting
  Entrant throughout;  ///< the same for the worst error on the way
  double at_most;      ///< for the units of `at_end`
  Entrant closed_form;  ///< for one time
  double closed_at_most;

  Bound bound() const { return {says + " by " + at_end.method, at_end.units, at_most}; }
  Bound closed_bound() const {
    return {says + " by " + closed_form.method, closed_form.units, closed_at_most};
  }
};

/// `hand`: the race whose right-hand side by hand is the unit.
ContestResult compete(const Contest&, const Race& hand);

/// Seconds of one exercise on one thread.
struct ExerciseTime {
  std::string number, title;
  double studying, trials;
  double longest_trial;
  std::string longest;  ///< which trial that is
};

struct SuiteTime {
  std::vector<ExerciseTime> exercises;  ///< in the book's order
  double one_thread;                    ///< wall time of the whole suite
  Spread two_threads;                   ///< the same, of several runs

  /// The longest study and then the longest trial: what no number of threads undercuts.
  double critical_path() const;
  double speed_up() const { return one_thread / two_threads.median; }
  Bound bound() const;
};

SuiteTime time_suite(const Reference& truth, const Progress& progress = {});

struct Bench {
  std::string no_instructions;  ///< why instructions were not counted; empty: they were
  std::vector<RaceResult> races;
  std::vector<ContestResult> contests;
  SuiteTime suite;
  ChainBench chains = {};
  std::vector<SeriesRace> series = {};

  std::vector<Bound> bounds() const;
  bool broken() const;
};

/// All of it, alone on the machine if the numbers are to mean anything.
Bench bench(const Reference& truth, const Progress& progress = {});

/// The tables for a terminal, each limit with whether it holds; the last line says whether all do.
std::string bench_view(const Bench&, const Screen& = {});
/// A row for each measured number; those with a limit say whether it holds.
Table bench_table(const Bench&);

}  // namespace oddity
