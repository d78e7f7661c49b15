#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "chapters/exercise.hpp"

namespace oddity {

/// The parameters of a heavy symmetric top, and after them the exercise's own.
template <std::size_t n>
constexpr std::array<Parameter, 11 + n> top_parameters(const Parameter (&own)[n]) {
  std::array<Parameter, 11 + n> all{
      {{"m", 1, "kg", "mass", 0.1, 10},
       {"l", 0.25, "m", "from the tip to the center of mass", 0.01, 1},
       {"mu1", 0.125, "kg m^2", "moment across the axis, about the tip", 0.01, 10},
       {"mu3", 0.0625, "kg m^2", "moment about the axis", 0.001, 10},
       {"g", 9.81, "m/s^2", "gravity", 0.1, 30},
       {"theta", 0.25, "rad", "precession angle at the start", -10, 10},
       {"phi", 0.5, "rad", "tilt at the start", 0.1, 3},
       {"psi", 0.75, "rad", "spin angle at the start", -10, 10},
       {"dtheta", 0.5, "rad/s", "its rate", -10, 10},
       {"dphi", 0.25, "rad/s", "its rate", -10, 10},
       {"dpsi", 30, "rad/s", "its rate", 1, 100}}};
  std::copy(own, own + n, all.begin() + 11);
  return all;
}

}  // namespace oddity
