#pragma once

#include <vector>

#include "chapters/03_rigid_body_motion/19_two_pulleys/models.hpp"
#include "chapters/exercise.hpp"

namespace oddity::ex03_19 {

std::vector<Claim> claims(double seed);
Provables proofs();
std::vector<Root> roots();

}  // namespace oddity::ex03_19
