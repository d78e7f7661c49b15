#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/study/candidate.hpp"

/// Finds the model, algorithm and setting to use for a scene, given a need.
///
///   Need need{.error = 0.01, .horizon = 2};
///   const Choice choice = choose(task, need, truth);
///   if (choice.chosen) std::cout << choice.chosen->model << " by " << choice.chosen->algorithm;
namespace oddity {

/// How an answer was found, and its cost.
struct Explanation {
  double truths = 0, search = 0, timing = 0, tests = 0, rest = 0;  ///< s
  std::string truth_by;                                            ///< reference of the requested start
  double truth_error = 0;                                          ///< in needs
  std::optional<double> truth_until = {};     ///< in the scene's unit of time; empty: to the end
  int starts = 0, methods = 0, settings = 0;  ///< tried
  int left = 0;          ///< methods not refined to their finest setting, as they cost more already
  long evaluations = 0;  ///< right-hand sides and closed forms, on the requested start
  int timed = 0;         ///< methods and settings
  int rounds = 0;        ///< rounds of tests; the last one passed if anything is chosen
};

/// A choice for a standalone program whose bits have to be the same everywhere.
struct InLockstep {
  std::vector<std::string> functions;      ///< the program's own, instead of the C library's: "sin"
  std::optional<double> times_usual = {};  ///< time of a frame over that of the usual program
  std::string measured = {};               ///< the compiler used, or the reason for no measurement
  std::map<std::string, std::vector<std::string>> left_out;  ///< methods not considered, by reason
};

struct Choice {
  Need need;
  /// The requested horizon, if the need's horizon is only a part of it: nothing passes over the part, and so
  /// over the whole; or the time limit left no more.
  std::optional<double> asked_horizon = {};
  bool is_decided_by_part = false;
  std::string exercise, quantity, time_unit;
  std::vector<std::string> units;  ///< units of the motion's errors
  std::vector<double> needs;       ///< the error requested in each of them
  std::vector<double> sizes = {};  ///< in each, the largest distance of the true motion from its first frame
  double rounding = 0;             ///< m, of a constraint: deviations up to this count as none
  /// One entry per method, by cost: the cheapest setting that passes with the need's margin, otherwise the
  /// cheapest that passes, otherwise the most accurate. A failing one was left at the first start that it
  /// failed on.
  std::vector<Candidate> candidates;
  /// Models and algorithms that were not refined to their finest setting. They cost too much already, and may
  /// pass at a finer one; or none can pass, as long double loses the motion.
  std::vector<std::pair<std::string, std::string>> left = {};
  std::optional<Candidate> chosen;
  bool by_objective =
      true;  ///< false: nothing that meets the objective passes, and this is the cheapest that does
  std::vector<Candidate> ties;  ///< same cost within a quarter, or within the spread, and not chosen
  /// The most expensive of the cheaper ones that finish: it fails, or passes without meeting the objective.
  std::optional<Candidate> next_cheaper;
  std::optional<Candidate> next_richer;   ///< the cheapest other model that passes
  std::optional<Candidate> nearest_miss;  ///< when nothing is chosen; judged on all starts
  /// If nothing is chosen: the method with the least work that passes on the requested start within the
  /// budget, with its result there and on the starts next to it.
  std::optional<Candidate> on_asked = {}, next_to_asked = {};
  std::vector<Candidate> engine;      ///< semi-implicit Euler at 60, 120 and 240 Hz, as in engines
  std::optional<Candidate> in_float;  ///< the chosen one in float, at its setting; unless it is in float
  double restart = 0;                 ///< extra evaluations after a restart of the chosen one
  std::optional<double>
      predictable;  ///< chaotic motions: time over which a start known to 1e-9 predicts the path
  std::vector<std::string> seen, unseen;
  std::vector<std::string> faulted = {};     ///< models that are shown to be wrong, and not chosen
  std::map<std::string, int> left_out = {};  ///< starts drawn with another kind of motion, as a hyperbola
  /// Numbers of unseen starts on which the choice was tried and on which it passes; for chaotic motions.
  int tried_in_chaos = 0, holding_in_chaos = 0;
  int failing_nearby = 0;       ///< unseen starts, where they need not pass: only the requested start counts
  std::string prices_are = {};  ///< their source
  std::string registers = {};   ///< SIMD registers for the bodies of the chosen one; empty: none
  std::optional<InLockstep> lockstep = {};
  Explanation explanation = {};

  bool was_followed(const Candidate&) const;
  /// The share of chaotic starts that the chosen one passes on lies in this interval with 95 % confidence
  /// [Wilson, J. Am. Stat. Assoc. 22 (1927) 209].
  std::pair<double, double> share_in_chaos() const;
  /// Margin of the chosen one on unseen starts: need over error.
  double margin() const { return 1 / chosen->unseen_error; }
};

/// Time of a run of a method [s].
using Price = std::function<Time(const Method&, double setting)>;

/// Time measured on this machine. Measures a short run three times and keeps the least disturbed one.
Time measured_price(const Method&, double setting);

/// A nanosecond for each evaluation of a run: by this price the answer is the same on every machine.
Time counted_price(const Method&, double setting);

/// Chooses on the task's start and two next to it, and tests on three others (the scene's `starts`, each up
/// to a tenth off). Repeats with fresh starts while the test fails. Of near ties takes the more accurate, of
/// those the simpler. Throws BadInput when the exercise has no motion or the need makes no sense, and
/// OutOfTime when the need's time limit is over.
Choice choose(const Task&, const Need&, const Reference&, const Price& = measured_price,
              const Progress& = {});

/// Price of a run over the horizon of a need.
using PriceOver = std::function<Price(const Need&)>;

/// As `choose`, but judges a long horizon over parts of it first, each eight times as long as the one before.
/// A method that fails over a part is not run further. If nothing passes over a part, or the time limit
/// leaves no more, the answer is for that part. Leaves out a part that cannot be judged. Throws OutOfTime if
/// no part is judged in time.
Choice choose_in_time(const Task&, const Need&, const Reference&, const PriceOver&, const Progress& = {});

}  // namespace oddity
