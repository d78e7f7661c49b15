#pragma once

#include <vector>

#include "chapters/03_rigid_body_motion/27_two_bodies/models.hpp"
#include "chapters/exercise.hpp"

/// Shared by the files of exercise 3.27.
namespace oddity::two_bodies {

using Bodies = Given<double>;

/// The exercise's default parameters.
constexpr Bodies usual{1, 2, 1, 1, 0.25, 0.5, 1.5};
constexpr double seconds = 4;  ///< duration of the motion
constexpr double need = 1e-6;  ///< m

/// Inputs of the table of paths, without the time.
std::vector<double> inputs(const Bodies&);

std::vector<Claim> claims(double seed, const Reference&);
Provables proofs();

}  // namespace oddity::two_bodies
