#pragma once

#include <vector>

#include "solvers/world.hpp"

/// Further errors of an engine: drifts of quantities that the world conserves, from the states of its bodies
/// at each frame, the first of them the start. NaN where the world conserves nothing of the kind.
namespace oddity::engines {

/// Largest change of the energy, as a part of the largest kinetic energy.
double energy_drift(const World&, const std::vector<std::vector<State>>& frames);

/// Largest change of a momentum that no force changes, as a part of the largest momentum of its kind. For
/// free bodies: the momentum across gravity, and the angular momentum about their mass center (above a smooth
/// and level floor, its part along gravity). For bodies that hang on one ball joint: the angular momentum
/// about it along gravity, and for a symmetric top also that about its axis.
double momentum_drift(const World&, const std::vector<std::vector<State>>& frames);

/// Largest distance between the ends of a joint, or largest error of a rod's length [m].
double joints_apart(const World&, const std::vector<std::vector<State>>& frames);

}  // namespace oddity::engines
