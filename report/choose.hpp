#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "report/need.hpp"
#include "report/results.hpp"
#include "report/run.hpp"

/// The least that a scene needs: the cheapest model, algorithm and setting that holds for a need.
namespace oddity {

/// A method at one setting, over several starts.
struct Tried {
  std::string model, algorithm, knob;
  double setting = 0;
  double error = 0;  ///< the largest over the starts it was chosen on, in units of what was asked
  Outcome outcome = Outcome::ok;
  std::string where = {};  ///< the start on which it ended so, unless ok
  double evaluations_a_frame = 0;
  double seconds_a_frame = 0;
  double unseen_error = std::numeric_limits<double>::quiet_NaN();  ///< over the starts it was not chosen on

  bool holds() const { return outcome == Outcome::ok; }
};

struct Choice {
  Need need;
  std::string quantity, unit;
  std::vector<ParameterValue> parameters;
  std::vector<Tried>
      tried;  ///< every method at its cheapest setting that holds, or else at its best; by cost
  std::optional<Tried> chosen;
  std::optional<Tried> next_cheaper;  ///< the dearest of those that are cheaper and fail
  std::optional<Tried> next_richer;   ///< the cheapest other model that holds
  std::optional<Tried> nearest_miss;  ///< when nothing is chosen
  std::vector<std::string> seen, unseen;

  /// How many times better than asked the chosen one was on starts that it was not chosen on.
  double margin() const { return 1 / chosen->unseen_error; }
};

/// What a method costs over the whole horizon [s].
using Cost = std::function<double(const Method&, double setting, const Trial&)>;

/// Measured on this machine.
double measured_cost(const Method&, double setting, const Trial&);

/// Chooses on the task's start and two beside it, tests on three others (the scene's `starts`, each up to a
/// tenth off), and moves on to the next cheapest, with fresh starts, while the test fails. Throws BadInput
/// when the exercise has no motion or the need is not positive.
Choice choose(const Task&, const Need&, const Reference&, const Cost& = measured_cost);

/// The choice as a sentence and a table, for a terminal.
std::string choice_text(const Choice&);

}  // namespace oddity
