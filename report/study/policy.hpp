#pragma once

namespace oddity {

/// The constants of the search behind `choose`, each with its reason.
struct Policy {
  // Starts.
  int seen = 3;  ///< the requested start and two next to it: with fewer, effects of the parameters are missed
  int reported = 5;         ///< further starts on which a choice for the requested start alone is reported
  int rounds = 4;           ///< each refuted choice adds its starts; a scene that refutes four has no choice
  int tried_in_chaos = 16;  ///< further starts: a share of them is known to about a tenth

  // Work, in evaluations per frame.
  double first_work = 16, more_work = 4;  ///< every method gets this budget, then four times as many, ...
  double far_more_work = 16;              ///< a setting that takes so many times the expected work is put off
  double luck = 4;  ///< settings whose errors would stay too large even with this luck are skipped

  // Time.
  double near_tie = 1.25;  ///< costs that differ by less are the same to an engineer, and on another machine
  double noisy_tie = 2;    ///< the most that counts as a tie, whatever the spread of a busy machine
  double as_accurate = 1.1;       ///< errors that differ by less are the same
  int budget_parts = 20;          ///< a budget has to hold in the costliest of so many parts of the horizon
  double long_evaluations = 1e4;  ///< a longer run is timed over its first frames

  // Horizon.
  double longer = 8;           ///< a long horizon is judged over parts, each so many times the one before,
  double far_costlier = 4;     ///< a method that cost so many times the choice over a part is not tried on
  double least_frames = 2400;  ///< from so many frames on: shorter parts decide nothing that takes time
};

inline constexpr Policy policy;

}  // namespace oddity
