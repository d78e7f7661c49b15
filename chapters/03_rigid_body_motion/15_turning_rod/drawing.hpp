#pragma once

#include <cmath>
#include <span>

#include "chapters/drawing.hpp"

namespace oddity::turning_rod {

/// Draws the mass on its rod; `observed` is its position [m].
template <class Parameters>
void draw(const Parameters& p, double t, std::span<const double> observed, Drawing& drawing) {
  const double s = p["s"], c = p["c"], turned = p["w"] * t, half = std::numbers::sqrt2 / 2;
  const Place mass{observed[0], observed[1], observed[2]}, foot{c, 0, 0};
  const double end = std::fmax(1.25 * s, 1.05 * std::hypot(mass.x, mass.y, mass.z));
  const auto at = [&](double along) { return half * along * Place{std::cos(turned), std::sin(turned), 1}; };
  drawing.in_space();
  drawing.axis({}, {std::fmax(1.2 * c, 0.8 * s), 0, 0}, "x1");
  drawing.axis({}, {0, 0.8 * s, 0}, "x2");
  drawing.axis({}, {0, 0, s}, "x3");
  drawing.guide(circle({0, 0, half * 1.25 * s}, half * 1.25 * s));
  drawing.spring(foot, mass, s / 14, "K");
  drawing.support({});
  drawing.support(foot);
  drawing.rod({}, at(end));
  drawing.body_with_trail(mass, s / 24, "m");
  drawing.length(at(s), {}, "s");
  drawing.length({}, foot, "c");
  drawing.angle({}, at(1), {0, 0, 1}, "45°");
}

}  // namespace oddity::turning_rod
