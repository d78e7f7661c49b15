#pragma once

#include "reference/reference.hpp"

namespace oddity {

/// Encloses true values. Throws BadInput if this build has no Arb.
Enclosing enclosing();

}  // namespace oddity
