#pragma once

#include <vector>

#include "chapters/exercise.hpp"
#include "chapters/random.hpp"

namespace oddity::ex07_11 {

std::vector<Claim> claims(const Random&);

}  // namespace oddity::ex07_11
