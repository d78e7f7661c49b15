#pragma once

#include <vector>

#include "chapters/03_rigid_body_motion/33_heavy_top/models.hpp"
#include "chapters/exercise.hpp"
#include "solvers/world.hpp"

/// Exercise 3.33's methods and claims.
namespace oddity::ex03_33 {

using Top = heavy_top::Given<double>;

inline constexpr double duration = 4;  ///< s, of the axis' motion

Quantity axis(const Top&, const Horizon&, const Reference&);
std::vector<Quantity> quantities(const Top&, const Reference&);
std::vector<Claim> claims(double seed, const Top& start);
Provables proofs();
std::vector<Root> roots(const Top&);
/// Frequency of the nutation of a top's axis.
double nods_a_second(const Top&);
/// Throws BadInput if no body has these moments.
engines::Staging staging(const heavy_top::Top<double>&);

}  // namespace oddity::ex03_33
