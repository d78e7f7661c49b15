#pragma once

#include <vector>

#include "chapters/03_rigid_body_motion/09_damped_ball/models.hpp"
#include "chapters/scene.hpp"

/// Shared by the files of exercise 3.9.
namespace oddity::ex03_09 {

using Ball = damped_ball::Given<double>;

// methods.cpp
Quantity path(const std::string& name, const std::string& says, const Ball&, const Horizon&,
              const Reference&);
/// For a ball released at rest, with friction below the critical.
Quantity first_arrival(const Ball& at_rest);
/// Excess over the critical friction, relative to it.
constexpr double above_critical = 1e-13;
/// Friction just above the critical, by the closed forms alone.
Quantity near_critical_path(const Ball&, const Horizon&, const Reference&);
Quantity stability_limit(const Ball&);

// claims.cpp
std::vector<Claim> claims(double seed);
Provables proofs();
std::vector<Root> roots();

}  // namespace oddity::ex03_09
