#pragma once

#include <span>

#include "chapters/drawing.hpp"

namespace oddity::oscillator {

/// Draws the mass on its spring; `observed` is its position [m] and velocity. The wall is beyond the reach of
/// the mass from any initial condition.
template <class Parameters>
void draw(const Parameters&, double, std::span<const double> observed, Drawing& drawing) {
  constexpr double wall = -2.2, height = 0.3;
  const Place mass{observed[0], 0};
  drawing.support({wall, height}, {wall, -height});
  drawing.guide({{0, height}, {0, -height}});
  drawing.spring({wall, 0}, mass, 0.2);
  drawing.body(mass, 0.15, "m");
}

}  // namespace oddity::oscillator
