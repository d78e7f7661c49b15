#pragma once

#include <span>

#include "chapters/drawing.hpp"

namespace oddity::oscillator {

/// How the mass on its spring looks: `observed` is its place [m] and velocity. The wall is where no start
/// brings the mass.
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
