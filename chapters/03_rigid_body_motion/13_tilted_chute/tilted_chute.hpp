#pragma once

#include <vector>

#include "chapters/03_rigid_body_motion/13_tilted_chute/models.hpp"
#include "chapters/scene.hpp"

/// Shared by the files of exercise 3.13.
namespace oddity::ex03_13 {

using Ball = tilted_chute::Given<double>;

// methods.cpp
Quantity swing(const Ball&, const Horizon&, const Reference&);
Quantity below_rim(const Ball&, const Horizon&, const Reference&);
Quantity on_center(const Ball&, const Horizon&, const Reference&);
Quantity from_rim(const Ball&, const Horizon&, const Reference&);

// claims.cpp
std::vector<Claim> claims(double seed);
Provables proofs();
std::vector<Root> roots();

}  // namespace oddity::ex03_13
