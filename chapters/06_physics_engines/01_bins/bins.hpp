#pragma once

#include <vector>

#include "chapters/exercise.hpp"

namespace oddity::ex06_01 {

std::vector<Claim> claims(const Parameters&);

}  // namespace oddity::ex06_01
