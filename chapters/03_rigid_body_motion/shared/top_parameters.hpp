#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "chapters/exercise.hpp"
#include "reference/bad_input.hpp"
#include "reference/text.hpp"

namespace oddity {

/// The parameters of a heavy symmetric top, followed by the exercise's own.
template <std::size_t n>
constexpr std::array<Parameter, 11 + n> top_parameters(const Parameter (&own)[n]) {
  std::array<Parameter, 11 + n> all{
      {{"m", 1, "kg", "mass", 1e-3, 1e4},
       {"l", 0.25, "m", "from the tip to the center of mass", 1e-3, 100},
       {"mu1", 0.125, "kg m^2", "moment across the axis, about the tip", 1e-9, 1e6},
       {"mu3", 0.0625, "kg m^2", "moment about the axis", 1e-9, 1e6},
       {"g", 9.81, "m/s^2", "gravity", 1e-3, 1e4},
       {"theta", 0.25, "rad", "precession angle at the start", -10, 10},
       {"phi", 0.5, "rad", "tilt at the start", 0.01, 3.14},
       {"psi", 0.75, "rad", "spin angle at the start", -10, 10},
       {"dtheta", 0.5, "rad/s", "its rate", -1e3, 1e3},
       {"dphi", 0.25, "rad/s", "its rate", -1e3, 1e3},
       {"dpsi", 30, "rad/s", "its rate", 0.01, 1e4}}};
  std::copy(own, own + n, all.begin() + 11);
  return all;
}

/// Throws BadInput if no body has these moments: about the center of mass, the moment about an axis never
/// exceeds the sum of the others.
inline void require_a_body(double m, double l, double mu1, double mu3) {
  const double across = mu1 - m * l * l;
  if (!(across > 0 && 2 * across >= mu3))
    throw BadInput("no body has these moments: mu1 - m l^2, which is " + format_significant(across, 4) +
                   " kg m^2, must be positive, and half of mu3 at least");
}
inline void require_a_body(const Parameters& p) { require_a_body(p["m"], p["l"], p["mu1"], p["mu3"]); }

}  // namespace oddity
