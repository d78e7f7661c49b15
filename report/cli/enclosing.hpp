#pragma once

#include "reference/reference.hpp"

namespace oddity {

/// What encloses true values in this build. Throws BadInput where it was built without Arb.
Enclosing enclosing();

}  // namespace oddity
