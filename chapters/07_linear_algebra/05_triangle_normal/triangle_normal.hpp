#pragma once

#include <vector>

#include "chapters/exercise.hpp"
#include "chapters/random.hpp"

namespace oddity::ex07_05 {

std::vector<Claim> claims(const Random&);
Provables proofs();
std::vector<Root> roots();

}  // namespace oddity::ex07_05
