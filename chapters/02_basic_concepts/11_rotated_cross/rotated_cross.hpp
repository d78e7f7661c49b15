#pragma once

#include <vector>

#include "chapters/exercise.hpp"

namespace oddity::ex02_11 {

std::vector<Claim> claims(double seed);
Provables proofs();

}  // namespace oddity::ex02_11
