#pragma once

#include <vector>

#include "chapters/03_rigid_body_motion/15_turning_rod/models.hpp"
#include "chapters/exercise.hpp"

namespace oddity::ex03_15 {

std::vector<Claim> claims(double seed, const Reference& truth);
Provables proofs();
std::vector<Root> roots();

}  // namespace oddity::ex03_15
