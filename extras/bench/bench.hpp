#pragma once

#include <string>
#include <vector>

#include "extras/bench/chain.hpp"
#include "extras/bench/loops.hpp"
#include "extras/bench/series.hpp"
#include "report/study/run.hpp"
#include "report/text/table_text.hpp"

/// Speed of this build on this machine, in this run. The integrators are compared with handwritten loops. The
/// best methods of two problems are measured in units of a handwritten right-hand side. The whole suite is
/// timed, too.
namespace oddity {

/// The median of many measurements, and half their interquartile range.
struct Spread {
  double median, half_width;
};
Spread spread_of(std::vector<double> measured);

/// A measured number and its limit. Noise decides nothing: the limit holds or is broken only if the number is
/// on that side by more than its spread.
struct Bound {
  std::string says;
  Spread measured;
  double at_most;

  bool holds() const { return measured.median + measured.half_width <= at_most; }
  bool broken() const { return measured.median - measured.half_width > at_most; }
};

/// Result of a race: seconds and instructions per right-hand side. Instructions are NaN where the machine
/// does not count them.
struct RaceResult {
  std::string model;
  int states;
  std::string algorithm;
  double at_most;  ///< for the ratio; 0: there is no limit
  Spread by_hand, inlined, precompiled;
  Spread ratio;  ///< ratio of inlined to by hand
  double instructions_by_hand, instructions_inlined;
  double difference;  ///< largest difference between the two final states

  Bound bound() const { return {model + " by " + algorithm, ratio, at_most}; }
};

/// Runs all sides in turn, in several rounds of all races, in batches of a fraction of a millisecond.
std::vector<RaceResult> race(const std::vector<Race>&, const Progress& progress = {});

/// A method that meets the tolerance of a contest.
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
  Entrant at_end;       ///< cheapest with the error at the end within the tolerance, here and at each finer
                        ///< setting
  Entrant throughout;   ///< likewise for the largest error over the motion
  double at_most;       ///< for the units of `at_end`
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
  Spread two_threads;                   ///< likewise on two threads, over several runs

  /// The longest study plus the longest trial: a lower bound for any number of threads.
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

/// Runs all of it. The numbers mean something only if nothing else runs on the machine.
Bench bench(const Reference& truth, const Progress& progress = {});

/// The tables for a terminal, each limit with its verdict; the last line is the verdict on all.
std::string bench_view(const Bench&, const Screen& = {});
/// A row for each measured number, with a verdict where there is a limit.
Table bench_table(const Bench&);

}  // namespace oddity
