#pragma once

#include <vector>

#include "chapters/exercise.hpp"
#include "chapters/random.hpp"

namespace oddity::ex07_03 {

std::vector<Claim> claims(Random);

}  // namespace oddity::ex07_03
