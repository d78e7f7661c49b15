#pragma once

#include <string>

#include "report/study/results.hpp"

namespace oddity {

/// A scene's map as SVG text: one panel per method, the scene's parameter across, the step upwards. Colours
/// and letters show the outcomes, a line theory's limit.
std::string map_svg(const ExerciseResult&);
std::string map_title(const ExerciseResult&);
/// The map's finding, in a sentence for its title.
std::string map_finding(const ExerciseResult&);

}  // namespace oddity
