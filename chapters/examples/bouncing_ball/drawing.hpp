#pragma once

#include <span>

#include "chapters/drawing.hpp"

namespace oddity::bouncing_ball {

/// Draws the ball at the height `observed`. It moves sideways at a constant speed, so that its flights lie
/// next to each other.
template <class Parameters>
void draw(const Parameters& p, double t, std::span<const double> observed, Drawing& drawing) {
  const double y0 = p["y0"], radius = y0 / 24;
  const auto at = [=](double time, double height) { return Place{time * y0 / 2, height + radius}; };
  drawing.support({-y0 / 4, 0}, {9 * y0 / 4, 0});
  drawing.body_with_trail(at(t, observed[0]), radius);
  drawing.length({-y0 / 8, 0}, {-y0 / 8, y0}, "y0");
  drawing.direction(at(1, y0), at(1, 0.7 * y0), "g");
}

}  // namespace oddity::bouncing_ball
