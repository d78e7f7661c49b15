#pragma once

#include <string>

#include "report/study/results.hpp"

namespace oddity {

/// The top of the front page: whether an exercise is right, why Euler fails, and which method to use; with
/// the book's worst motion.
std::string doors(const Results&);
/// The exercise whose picture is shown there; null if none moves.
const ExerciseResult* exercise_in_motion(const Results&);

}  // namespace oddity
