#pragma once

#include <string>
#include <vector>

#include "report/bench_loops.hpp"
#include "report/run.hpp"

/// How fast this build is on this machine, in this run: the integrators against loops written by hand, the
/// best methods of two problems in units of a right-hand side written by hand, and the whole suite.
namespace oddity {

/// The median of many measurements, and half the distance of their quartiles.
struct Spread {
  double median, half_width;
};
Spread spread_of(std::vector<double> measured);

/// A race as it was run: seconds and instructions a right-hand side; instructions are NaN where the machine
/// counts none.
struct RaceResult {
  std::string model;
  int states;
  std::string algorithm;
  double limit;  ///< of the ratio; 0: none is set
  Spread by_hand, inlined, precompiled;
  Spread ratio;  ///< of inlined to by hand
  double instructions_by_hand, instructions_inlined;
  double difference;  ///< the largest, between the two final states

  bool holds() const { return limit == 0 || ratio.median <= limit; }
};

/// Runs both sides in turn, many times, in batches of a fraction of a millisecond.
std::vector<RaceResult> race(const std::vector<Race>&);

/// A method that meets the need of a contest.
struct Entrant {
  std::string method;
  double setting;
  long evaluations;
  double final_error, worst_error;
  Time time;
  double units;  ///< its time over that of one right-hand side written by hand
};

struct ContestResult {
  std::string says, hand;
  double need, unit_seconds;
  Entrant at_end;      ///< the cheapest whose error at the end meets the need, at this and each finer setting
  Entrant throughout;  ///< the same for the worst error on the way
  double limit;        ///< for `at_end`
  std::string closed_form;
  Time closed_time;  ///< for one time
  double closed_units, closed_limit, closed_final_error, closed_worst_error;
};

/// `unit_seconds`: the time of one right-hand side of the contest's model by hand.
ContestResult compete(const Contest&, double unit_seconds);

/// Seconds of one exercise on one thread.
struct ExerciseTime {
  std::string number, title;
  double studying, trials;
  double longest_trial;
  std::string longest;  ///< which trial that is
};

struct SuiteTime {
  std::vector<ExerciseTime> exercises;  ///< in the book's order
  double one_thread, two_threads;       ///< wall time of the whole suite

  /// The longest study and then the longest trial: what no number of threads undercuts.
  double critical_path() const;
  double speed_up() const { return one_thread / two_threads; }
};

SuiteTime time_suite(const Reference& truth, const Progress& progress = {});

struct Bench {
  std::string no_instructions;  ///< why instructions were not counted; empty: they were
  std::vector<RaceResult> races;
  std::vector<ContestResult> contests;
  SuiteTime suite;
};

/// All of it, alone on the machine if the numbers are to mean anything.
Bench bench(const Reference& truth, const Progress& progress = {});

/// The tables for a terminal, each limit with whether it held.
std::string bench_view(const Bench&);

}  // namespace oddity
