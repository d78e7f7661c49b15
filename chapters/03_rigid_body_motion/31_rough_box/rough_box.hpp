#pragma once

#include <vector>

#include "chapters/03_rigid_body_motion/31_rough_box/models.hpp"
#include "chapters/exercise.hpp"

/// Exercise 3.31's methods and claims.
namespace oddity::ex03_31 {

using Box = rough_box::Given<double>;

Quantity slide(const Box&, const Horizon&, const Reference&);
/// Time and position at which the box comes to rest.
std::vector<Quantity> at_rest(const Box&, const Reference&);

std::vector<Claim> claims();

}  // namespace oddity::ex03_31
