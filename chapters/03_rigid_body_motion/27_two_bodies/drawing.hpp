#pragma once

#include <cmath>
#include <span>

#include "chapters/drawing.hpp"

namespace oddity::two_bodies {

/// Draws the two bodies relative to their center of mass; `observed` is the second relative to the first [m].
template <class Parameters>
void draw(const Parameters& p, double, std::span<const double> observed, Drawing& drawing) {
  const double m1 = p["m1"], m2 = p["m2"], r0 = p["r0"], phi0 = p["phi0"], m = m1 + m2;
  const Place between{observed[0], observed[1]}, first{r0 * std::cos(phi0), r0 * std::sin(phi0)};
  const auto size = [&](double mass) { return r0 / 16 * std::cbrt(mass / m); };
  const Place one = -m2 / m * between, other = m1 / m * between;
  drawing.axis({-0.7 * r0, 0}, {1.1 * r0, 0}, "x");
  drawing.axis({0, -0.7 * r0}, {0, 0.9 * r0}, "y");
  drawing.guide({one, other});
  drawing.body_with_trail(one, size(m1), "m1");
  drawing.body_with_trail(other, size(m2), "m2");
  drawing.angle({}, {0.4 * r0, 0}, first, "φ0");
  drawing.length(one, other, "r0");
  const Place across{-first.y, first.x}, rate = p["phi0_dot"] * across + p["r0_dot"] / r0 * first;
  drawing.direction(other, other + 0.3 * m1 / m * rate, "");
  drawing.direction(one, one - 0.3 * m2 / m * rate, "");
}

}  // namespace oddity::two_bodies
