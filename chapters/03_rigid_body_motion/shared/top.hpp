#pragma once

#include "chapters/03_rigid_body_motion/33_heavy_top/models.hpp"
#include "chapters/scene.hpp"

namespace oddity::top {

/// How long the tops of exercises 3.33 and 3.35 are looked at.
inline constexpr double duration = 4;

}  // namespace oddity::top
