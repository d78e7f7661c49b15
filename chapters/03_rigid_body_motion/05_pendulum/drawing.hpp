#pragma once

#include <cmath>
#include <span>

#include "chapters/drawing.hpp"

namespace oddity::pendulum {

/// Draws the pendulum at the angle `observed` [rad].
template <class Parameters>
void draw(const Parameters& p, double, std::span<const double> observed, Drawing& drawing) {
  const double L = p["L"];
  const auto at = [L](double angle) { return Place{L * std::sin(angle), -L * std::cos(angle)}; };
  const Place bob = at(observed[0]);
  drawing.support({});
  drawing.rod({}, bob);
  drawing.body_with_trail(bob, L / 16);
  drawing.angle({}, at(0), bob, "a");
  drawing.length({}, bob, "L");
  drawing.direction({-0.5 * L, -0.3 * L}, {-0.5 * L, -0.55 * L}, "g");
}

}  // namespace oddity::pendulum
