#pragma once

#include <span>
#include <string>

#include "report/study/engines.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// recipes.html: what is enough for each scene in a game, and what every other method takes.
std::string recipes_page(const Results&);
/// The same of one scene, with its code and what engines make of it; empty where nothing is enough.
std::string recipe_section(const ExerciseResult&, std::span<const EngineContest>);

}  // namespace oddity
