#pragma once

#include <string>

#include "report/study/results.hpp"

namespace oddity {

/// What a reader comes for, above the fold of the front page: whether an exercise is right, why Euler fails,
/// and what to use; with the motion that the book gets wrong by most.
std::string doors(const Results&);
/// The exercise whose picture stands there; null where none moves.
const ExerciseResult* exercise_in_motion(const Results&);

}  // namespace oddity
