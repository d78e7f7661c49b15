#pragma once

#include <string>

#include "report/study/results.hpp"

namespace oddity {

/// 3.5.html: the question, the set-up, the player, the findings, the claims, the quantities, the limits.
std::string exercise_page(const Results&, const ExerciseResult&);

}  // namespace oddity
