#pragma once

#include <string>
#include <vector>

#include "report/study/results.hpp"

namespace oddity {

/// Self-test of the comparisons in a claim's checks. Replaces the left *result* of each passing check by a
/// wrong one. It has the sign flipped or, for a value near zero, the size of its terms added; is twice as
/// large; or is ten tolerances away. The check must then fail, so its tolerance is narrower than the value
/// and than its scale. No formula runs again: only the claim's near misses test the check's sensitivity.
/// Returns the perturbations that went unnoticed, as "claim, quantity: perturbation".
std::vector<std::string> unnoticed_perturbations(const JudgedClaim&);

}  // namespace oddity
