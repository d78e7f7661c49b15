#pragma once

#include <string>
#include <vector>

#include "solvers/world.hpp"

namespace oddity::engines {

/// A world in MuJoCo's own language, as files that include each other; the last is the root.
std::vector<std::string> mujoco_xml(const World&, const std::string& options);

}  // namespace oddity::engines
