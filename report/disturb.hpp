#pragma once

#include <string>
#include <vector>

#include "report/results.hpp"

namespace oddity {

/// The self-test of a claim's checks: each check that holds is disturbed on its left side (the sign flipped
/// or, for a value near zero, the size of its terms added; a factor of two; ten tolerances added) and must
/// then fail. Returns the disturbances that went unnoticed, as "quantity: what was done".
std::vector<std::string> unnoticed_disturbances(const JudgedClaim&);

}  // namespace oddity
