#pragma once

#include <vector>

#include "chapters/03_rigid_body_motion/11_paraboloid_hill/models.hpp"
#include "chapters/scene.hpp"

namespace oddity::ex03_11 {

// claims.cpp
std::vector<Claim> claims(double seed);
Provables proofs();
std::vector<Root> roots();

}  // namespace oddity::ex03_11
