#pragma once

#include <vector>

#include "chapters/03_rigid_body_motion/23_spring_bar/models.hpp"
#include "chapters/exercise.hpp"

namespace oddity::ex03_23 {

/// The exercise's default parameters.
constexpr spring_bar::Given<double> usual{1, 1, 0.5, 98.1, 0.8, 9.81, 1, 0.3, 0};

std::vector<Claim> claims(double seed);
Provables proofs();

}  // namespace oddity::ex03_23
