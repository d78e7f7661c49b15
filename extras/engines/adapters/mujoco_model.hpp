#pragma once

#include <mujoco/mujoco.h>

#include <string>

#include "solvers/world.hpp"

namespace oddity::engines {

/// The world compiled by MuJoCo, with a variant's settings. Throws NotExpressible.
mjModel* mujoco_model(const World&, const std::string& variant);

}  // namespace oddity::engines
