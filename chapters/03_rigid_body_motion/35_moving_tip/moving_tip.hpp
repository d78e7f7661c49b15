#pragma once

#include <vector>

#include "chapters/03_rigid_body_motion/35_moving_tip/models.hpp"
#include "chapters/exercise.hpp"

/// Exercise 3.35's methods and claims.
namespace oddity::ex03_35 {

using Top = heavy_top::Top<double>;

Quantity axis(const Top&, const Horizon&, const Reference&);
std::vector<Quantity> quantities(const Top&, const Reference&);
std::vector<Claim> claims(double seed);
std::vector<Root> roots();

}  // namespace oddity::ex03_35
