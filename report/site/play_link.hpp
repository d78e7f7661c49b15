#pragma once

#include <string>
#include <vector>

#include "report/study/results.hpp"

namespace oddity {

/// A method of a scene's motion for a player.
struct Played {
  std::string model, algorithm;
  double setting;
};

/// Link to the exercise's player with these methods, as permalink.js reads it.
std::string link_to_player(const ExerciseResult&, const std::vector<Played>&);
/// Link with these algorithms at this step, on the model with the most trials; leaves out those not tried on
/// it.
std::string link_to_players(const ExerciseResult&, const std::vector<std::string>& algorithms, double step);

}  // namespace oddity
