#pragma once

#include <vector>

#include "chapters/03_rigid_body_motion/21_pipe_and_disk/models.hpp"
#include "chapters/exercise.hpp"

namespace oddity::ex03_21 {

std::vector<Claim> claims(double seed);
std::vector<Root> roots();

}  // namespace oddity::ex03_21
