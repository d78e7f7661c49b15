#pragma once

#include <cmath>
#include <span>

#include "chapters/drawing.hpp"

namespace oddity::damped_ball {

/// Draws the ball on its spring; `observed` is its position [m].
template <class Parameters>
void draw(const Parameters& p, double, std::span<const double> observed, Drawing& drawing) {
  const Place ball{observed[0], observed[1]}, first{p["p1"], p["p2"]}, velocity{p["v1"], p["v2"]};
  const double size = std::fmax(std::hypot(first.x, first.y), 0.5 * std::hypot(velocity.x, velocity.y));
  drawing.axis({-0.7 * size, 0}, {1.3 * size, 0}, "x");
  drawing.axis({0, -0.7 * size}, {0, 1.3 * size}, "y");
  drawing.spring({}, ball, size / 9, "c");
  drawing.support({});
  drawing.body_with_trail(ball, size / 18, "m");
  drawing.guide({{first.x, 0}, first, {0, first.y}});
  drawing.label({first.x, 0}, "p1");
  drawing.label({0, first.y}, "p2");
  drawing.direction(first, first + 0.3 * velocity, "v");
}

}  // namespace oddity::damped_ball
