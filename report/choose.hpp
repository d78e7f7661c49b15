#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "report/tried.hpp"

/// The least that a scene needs: the cheapest model, algorithm and setting that holds for a need.
namespace oddity {

struct Choice {
  Need need;
  std::string quantity, unit, time_unit;
  std::vector<Tried>
      tried;  ///< every method at its cheapest setting that holds, or else at its best; by cost
  std::optional<Tried> chosen;
  std::optional<Tried> next_cheaper;  ///< the dearest of those that are cheaper, come to an end and fail
  std::optional<Tried> next_richer;   ///< the cheapest other model that holds
  std::optional<Tried> nearest_miss;  ///< when nothing is chosen
  std::vector<std::string> seen, unseen;

  /// How many times better than asked the chosen one was on starts that it was not chosen on.
  double margin() const { return 1 / chosen->unseen_error; }
};

/// What a method costs over the whole horizon [s].
using Price = std::function<double(const Method&, double setting, const Trial&)>;

/// Measured on this machine.
double measured_price(const Method&, double setting, const Trial&);

/// Chooses on the task's start and two beside it, tests on three others (the scene's `starts`, each up to a
/// tenth off), and moves on to the next cheapest, with fresh starts, while the test fails. Throws BadInput
/// when the exercise has no motion or the need is not positive.
Choice choose(const Task&, const Need&, const Reference&, const Price& = measured_price);

/// The choice as a sentence and a table, for a terminal.
std::string choice_text(const Choice&);

}  // namespace oddity
