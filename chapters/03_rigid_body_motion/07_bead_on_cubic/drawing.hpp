#pragma once

#include <cmath>
#include <span>

#include "chapters/drawing.hpp"

namespace oddity::bead_on_cubic {

/// Draws the bead on its wire; `observed` is its position [m].
template <class Parameters>
void draw(const Parameters& p, double, std::span<const double> observed, Drawing& drawing) {
  const double q0 = p["q0"];
  drawing.in_space();
  drawing.axis({}, {1.7 * q0, 0, 0}, "x");
  drawing.axis({}, {0, 1.3 * q0 * q0, 0}, "y");
  drawing.axis({}, {0, 0, 1.3 * q0 * q0 * q0}, "z");
  drawing.track(sampled(-1.35 * q0, 1.15 * q0, 96, [](double q) { return Place{q, q * q, q * q * q}; }));
  const Place first{q0, q0 * q0, q0 * q0 * q0}, foot{q0, q0 * q0, 0};
  drawing.guide({{q0, 0, 0}, foot, first});
  drawing.body_with_trail({observed[0], observed[1], observed[2]},
                          std::hypot(first.x, first.y, first.z) / 25);
  drawing.label({q0, 0, 0}, "q0");
  drawing.direction({0, 1.3 * foot.y, first.z}, {0, 1.3 * foot.y, 0.4 * first.z}, "g");
}

}  // namespace oddity::bead_on_cubic
