#pragma once

#include <span>
#include <string>

#include "report/study/engines.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// recipes.html: the cheapest sufficient method for each scene in a game, and the cost of every other one.
std::string recipes_page(const Results&);
/// The part of one scene, with its code and engines' results; empty if nothing is enough.
std::string recipe_section(const ExerciseResult&, std::span<const EngineContest>);

}  // namespace oddity
