#pragma once

#include <cmath>
#include <span>

#include "chapters/drawing.hpp"

namespace oddity::paraboloid_hill {

/// Draws the particle on its hill; `observed` is its position [m].
template <class Parameters>
void draw(const Parameters& p, double, std::span<const double> observed, Drawing& drawing) {
  const double a1 = p["a1"], a2 = p["a2"], v1 = p["v1"], v2 = p["v2"];
  const double depth = 2 * p["g"];  // no deeper than a free fall of two seconds
  const auto at = [&](double down, double angle) {
    const double r = std::sqrt(down);
    return Place{r * a1 * std::cos(angle), r * a2 * std::sin(angle), -down};
  };
  drawing.in_space();
  for (int i = 1; i <= 5; ++i) {
    const double down = depth * i * i / 25;
    drawing.track(sampled(0, 2 * std::numbers::pi, 40, [&](double angle) { return at(down, angle); }));
  }
  for (int i = 0; i < 12; ++i) {
    const double angle = std::numbers::pi * i / 6;
    drawing.track(sampled(0, std::sqrt(depth), 10, [&](double r) { return at(r * r, angle); }));
  }
  const double size = std::sqrt(depth) * std::fmin(a1, a2);
  drawing.axis({}, {1.2 * std::sqrt(depth) * a1, 0, 0}, "x1");
  drawing.axis({}, {0, 1.1 * std::sqrt(depth) * a2, 0}, "x2");
  drawing.axis({}, {0, 0, 0.3 * depth}, "x3");
  drawing.body_with_trail({observed[0], observed[1], observed[2]}, size / 18);
  drawing.direction({}, 1.3 * size / std::hypot(v1, v2) * Place{v1, v2, 0}, "v");
}

}  // namespace oddity::paraboloid_hill
