#pragma once

#include <vector>

#include "chapters/03_rigid_body_motion/21_pipe_and_disk/models.hpp"
#include "chapters/exercise.hpp"

namespace oddity::ex03_21 {

/// The exercise's default parameters.
constexpr pipe_and_disk::Given<double> usual{1, 2, 0.5, 1, 3, 0.2, 2, 0.5, 10};
constexpr double nearly_upright = 0.01;  ///< rad

std::vector<Claim> claims(double seed);
Provables proofs();
std::vector<Root> roots();

}  // namespace oddity::ex03_21
