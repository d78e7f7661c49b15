#pragma once

#include <string>

#include "report/study/results.hpp"

namespace oddity {

/// The published motion of a scene beside the true one, drawn small, as an SVG that a script sets going.
/// Empty where the book's motion is not among the recorded ones, or is within what a game allows, or the
/// scene does not say how it looks.
std::string moving_picture(const ExerciseResult&);

}  // namespace oddity
