#pragma once

#include <vector>

#include "solvers/world.hpp"

/// What an engine does wrong beside the path: what a world conserves, from the states of its bodies frame
/// after frame, the first of them the start. NaN where the world conserves nothing of the kind.
namespace oddity::engines {

/// By how much the energy changes at most, as a part of the largest kinetic energy.
double energy_drift(const World&, const std::vector<std::vector<State>>& frames);

/// By how much a momentum that no force changes does so at most, as a part of the largest momentum of its
/// kind. Of bodies that nothing holds these are the momentum across gravity and the angular momentum about
/// their mass center (above a smooth and level floor, its part along gravity); of bodies that hang on one
/// ball joint, the angular momentum about it along gravity, and that of a symmetric top about its axis.
double momentum_drift(const World&, const std::vector<std::vector<State>>& frames);

/// How far the ends of a joint come apart, or by how much a rod's length is off, at most [m].
double joints_apart(const World&, const std::vector<std::vector<State>>& frames);

}  // namespace oddity::engines
