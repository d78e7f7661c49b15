#pragma once

#include <string>

#include "report/study/results.hpp"

namespace oddity {

/// A scene's map as SVG text: one panel per method, the scene's parameter across, the step upwards, outcomes
/// by colour and letter, theory's limit as a line.
std::string map_svg(const ExerciseResult&);
std::string map_title(const ExerciseResult&);
/// What the map says, in a sentence for its title.
std::string map_finding(const ExerciseResult&);

}  // namespace oddity
