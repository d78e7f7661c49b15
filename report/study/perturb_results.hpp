#pragma once

#include <string>
#include <vector>

#include "report/study/results.hpp"

namespace oddity {

/// The self-test of how a claim's checks compare: the left *result* of each check that holds is replaced by
/// one that is wrong (the sign flipped or, for a value near zero, the size of its terms added; twice as
/// large; ten tolerances away), and the check must then fail. This shows that its tolerance is narrower than
/// the value and than its scale; it runs no formula again, so that what the check is sensitive to is shown by
/// the claim's near misses alone. Returns the perturbations that went unnoticed, as "claim, quantity: what
/// was done".
std::vector<std::string> unnoticed_perturbations(const JudgedClaim&);

}  // namespace oddity
