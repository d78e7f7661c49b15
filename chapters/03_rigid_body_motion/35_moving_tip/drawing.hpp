#pragma once

#include <cmath>
#include <span>

#include "chapters/03_rigid_body_motion/33_heavy_top/drawing.hpp"
#include "chapters/drawing.hpp"

namespace oddity::moving_tip {

/// Draws the top on its moving tip; `observed` is the direction of its axis.
template <class Parameters>
void draw(const Parameters& p, double t, std::span<const double> observed, Drawing& drawing) {
  const double A = p["A"], size = 2.5 * p["l"];
  const Place tip{A * std::sin(p["lambda"] * t), 0, 0};
  drawing.in_space();
  drawing.axis({-size, 0, 0}, {size, 0, 0}, "x");
  drawing.axis({}, {0, size, 0}, "y");
  heavy_top::draw_top(p, tip, {observed[0], observed[1], observed[2]}, drawing);
  drawing.track({{-A, 0, 0}, {A, 0, 0}});
  drawing.length({}, {A, 0, 0}, "A");
}

}  // namespace oddity::moving_tip
