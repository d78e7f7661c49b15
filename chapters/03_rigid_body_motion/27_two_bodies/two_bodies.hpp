#pragma once

#include <vector>

#include "chapters/03_rigid_body_motion/27_two_bodies/models.hpp"
#include "chapters/exercise.hpp"

/// What the files of exercise 3.27 share.
namespace oddity::two_bodies {

using Bodies = Given<double>;

/// Of the table of paths, but for the time.
std::vector<double> inputs(const Bodies&);

std::vector<Claim> claims(double seed, const Reference&);

}  // namespace oddity::two_bodies
