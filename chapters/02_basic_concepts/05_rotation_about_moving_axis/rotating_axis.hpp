#pragma once

#include <vector>

#include "chapters/exercise.hpp"

/// Exercise 2.5: shared by the files of the exercise.
namespace oddity::rotating_axis {

Quantity angular_velocity(const Parameters&, const Reference&);

std::vector<Claim> claims(double seed);
Provables proofs();
std::vector<Root> roots();

}  // namespace oddity::rotating_axis
