#pragma once

#include <span>
#include <string>

#include "reference/proofs.hpp"
#include "report/study/engines.hpp"
#include "report/study/results.hpp"

namespace oddity {

/// 3.5.html: the question, the set-up, the player, the recipe, the findings, the claims, the quantities and
/// the limits.
std::string exercise_page(const Results&, const ExerciseResult&, const ProvedClaims& = {},
                          std::span<const EngineContest> = {});

/// The page of the example that is no exercise (example.hpp).
std::string example_page(const ExerciseResult&);

}  // namespace oddity
