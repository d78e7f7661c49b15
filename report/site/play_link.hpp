#pragma once

#include <string>
#include <vector>

#include "report/study/results.hpp"

namespace oddity {

/// A method of a scene's motion as a player is to show it.
struct Played {
  std::string model, algorithm;
  double setting;
};

/// The address of the exercise's player with these methods, as permalink.js reads it.
std::string link_to_player(const ExerciseResult&, const std::vector<Played>&);
/// With those of the algorithms, at this step, that have been tried on the model which most are tried on.
std::string link_to_players(const ExerciseResult&, const std::vector<std::string>& algorithms, double step);

}  // namespace oddity
