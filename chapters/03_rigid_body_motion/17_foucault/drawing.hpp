#pragma once

#include <cmath>
#include <span>

#include "chapters/drawing.hpp"

namespace oddity::foucault {

/// Draws the bob; `observed` is its position west and north of the lowest point [m].
template <class Parameters>
void draw(const Parameters& p, double, std::span<const double> observed, Drawing& drawing) {
  const double L = p["L"], x = observed[0], y = observed[1];
  const auto at = [](double west, double north, double up) { return Place{north, west, up}; };
  const double reach = L * std::fmin(1, 1.6 * std::sin(std::fmin(p["phi"], std::numbers::pi / 2)));
  const Place bob = at(x, y, -std::sqrt(std::fmax(0, L * L - x * x - y * y)));
  const double floor = -1.12 * L;
  const Place center = at(0, 0, floor), below{bob.x, bob.y, floor};
  drawing.in_space();
  drawing.track(circle(center, reach));
  drawing.axis(center, at(1.35 * reach, 0, floor), "x");
  drawing.axis(center, at(0, 1.35 * reach, floor), "y");
  drawing.guide({{}, center});
  drawing.guide({bob, below, center});
  drawing.support({});
  drawing.rope({{}, bob});
  drawing.body_with_trail(bob, L / 28);
  drawing.angle({}, at(0, 0, -0.5 * L), bob, "φ");
  drawing.angle(center, at(reach, 0, floor), below, "θ");
  drawing.length({}, bob, "L");
}

}  // namespace oddity::foucault
