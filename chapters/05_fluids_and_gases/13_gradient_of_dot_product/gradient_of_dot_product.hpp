#pragma once

#include <vector>

#include "chapters/exercise.hpp"
#include "chapters/random.hpp"

namespace oddity::ex05_13 {

std::vector<Claim> claims(const Random&);
Provables proofs();

}  // namespace oddity::ex05_13
