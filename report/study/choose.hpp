#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/study/candidate.hpp"

/// What to use for a scene: the model, algorithm and setting that hold for a need.
///
///   Need need{.error = 0.01, .horizon = 2};
///   const Choice choice = choose(task, need, truth);
///   if (choice.chosen) std::cout << choice.chosen->model << " by " << choice.chosen->algorithm;
namespace oddity {

/// How an answer was found, and what it took.
struct Explanation {
  double truths = 0, search = 0, timing = 0, tests = 0, rest = 0;  ///< s
  std::string truth_by;                                            ///< of the start asked for
  double truth_error = 0;                                          ///< in needs
  std::optional<double> truth_until = {};     ///< in the scene's unit of time; none: to the end
  int starts = 0, methods = 0, settings = 0;  ///< tried
  int left = 0;  ///< methods that were not followed to their finest setting, as they cost more already
  long evaluations = 0;  ///< of right-hand sides and closed forms, on the start asked for
  int timed = 0;         ///< methods and settings
  int rounds = 0;        ///< of tests, the last of which held if anything is chosen
};

/// A choice whose bits are asked to be the same everywhere, as a program of one's own.
struct InLockstep {
  std::vector<std::string> functions;      ///< its own instead of the C library's: "sin"
  std::optional<double> times_usual = {};  ///< what a frame takes, in what the usual program takes
  std::string measured = {};               ///< by what compiler, or why it is not
  std::map<std::string, std::vector<std::string>> left_out;  ///< what was not asked, by the reason
};

struct Choice {
  Need need;
  /// Where the need's horizon is only a part of the one that was asked for: that one. Nothing that is asked
  /// holds over the part, and so over the whole; or the time limit left no more.
  std::optional<double> asked_horizon = {};
  bool is_decided_by_part = false;
  std::string exercise, quantity, time_unit;
  std::vector<std::string> units;  ///< of the motion's errors
  std::vector<double> needs;       ///< the error asked for in each of them
  std::vector<double> sizes = {};  ///< in each, the farthest that the true motion goes from its first frame
  double rounding = 0;             ///< m, of a constraint: what is off by no more is held
  /// Every method at its cheapest setting that holds with the need's margin, else at the cheapest that holds,
  /// else at the best that was tried; by cost. What fails is left at the first start on which it does.
  std::vector<Candidate> candidates;
  /// The models and algorithms that were not followed to their finest setting: as they cost too much already,
  /// and one that fails may hold at a finer one; or as none can hold, where long double loses the motion.
  std::vector<std::pair<std::string, std::string>> left = {};
  std::optional<Candidate> chosen;
  bool by_objective =
      true;  ///< false: nothing that the objective wants holds, and this is the cheapest that does
  std::vector<Candidate>
      ties;  ///< what costs the same within a quarter, or within the spread, and was passed over
  /// The most expensive of those tried that are cheaper and come to an end: it fails, or holds without what
  /// the objective wants.
  std::optional<Candidate> next_cheaper;
  std::optional<Candidate> next_richer;   ///< the cheapest other model that holds
  std::optional<Candidate> nearest_miss;  ///< when nothing is chosen; judged on all starts
  /// When nothing is chosen: what holds on the start asked for within the budget, with the least work, as it
  /// ends there; and as it ends on those beside it.
  std::optional<Candidate> on_asked = {}, beside_asked = {};
  std::vector<Candidate> engine;      ///< semi-implicit Euler at 60, 120 and 240 Hz, as engines have it
  std::optional<Candidate> in_float;  ///< the chosen one in float at its setting, unless it is in float
  double restart = 0;  ///< evaluations that a restart of the chosen one costs beside the steady ones
  std::optional<double>
      predictable;  ///< of a chaotic motion: until when a start known to 1e-9 tells the path
  std::vector<std::string> seen, unseen;
  std::vector<std::string> faulted = {};     ///< models that are shown to be wrong, and not chosen
  std::map<std::string, int> left_out = {};  ///< starts drawn that move in another way, as on a hyperbola
  /// Of a chaotic motion: how many of the starts that it was not chosen on it was tried on, and holds on.
  int tried_in_chaos = 0, holding_in_chaos = 0;
  int failing_beside = 0;  ///< of those unseen, where they need not hold: the start asked for alone was asked
  std::string prices_are = {};  ///< where they come from
  std::string registers = {};   ///< that the bodies of the chosen one are side by side in; empty: none
  std::optional<InLockstep> lockstep = {};
  Explanation explanation = {};

  bool was_followed(const Candidate&) const;
  /// The share of starts in chaos on which the chosen one holds lies between these with a confidence of 95 %
  /// [Wilson, J. Am. Stat. Assoc. 22 (1927) 209].
  std::pair<double, double> share_in_chaos() const;
  /// How many times better than asked the chosen one was on starts that it was not chosen on.
  double margin() const { return 1 / chosen->unseen_error; }
};

/// What a run of a method takes [s].
using Price = std::function<Time(const Method&, double setting)>;

/// Measured on this machine: what is brief three times over, of which the least disturbed counts.
Time measured_price(const Method&, double setting);

/// Chooses on the task's start and two beside it, tests on three others (the scene's `starts`, each up to a
/// tenth off), and goes on, with fresh starts, while the test fails. Of near ties the more accurate is taken,
/// of those the simpler. Throws BadInput when the exercise has no motion or the need makes no sense, and
/// OutOfTime when the need's time limit is over.
Choice choose(const Task&, const Need&, const Reference&, const Price& = measured_price,
              const Progress& = {});

/// What a run costs over the horizon of a need.
using PriceOver = std::function<Price(const Need&)>;

/// As `choose`; over a long horizon first over parts of it, each eight times as long as the one before. What
/// fails over a part is followed no further; where nothing holds over it the answer is over it, and so is one
/// where the time limit leaves no more. A part that cannot be judged is left out. Throws OutOfTime where no
/// part is judged in time.
Choice choose_in_time(const Task&, const Need&, const Reference&, const PriceOver&, const Progress& = {});

}  // namespace oddity
