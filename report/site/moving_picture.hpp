#pragma once

#include <string>

#include "report/study/results.hpp"

namespace oddity {

/// The published motion of a scene next to the true one, drawn small, as an SVG that a script animates. Empty
/// if the book's motion is not recorded, is within a game's tolerance, or the scene defines no drawing.
std::string moving_picture(const ExerciseResult&);

}  // namespace oddity
