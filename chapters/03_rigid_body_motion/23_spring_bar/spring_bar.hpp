#pragma once

#include <vector>

#include "chapters/03_rigid_body_motion/23_spring_bar/models.hpp"
#include "chapters/exercise.hpp"

namespace oddity::ex03_23 {

std::vector<Claim> claims(double seed);

}  // namespace oddity::ex03_23
