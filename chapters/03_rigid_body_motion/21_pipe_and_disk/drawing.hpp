#pragma once

#include <cmath>
#include <span>

#include "chapters/drawing.hpp"

namespace oddity::pipe_and_disk {

/// Draws the disk on its pipe; `observed` are its center's x and y [m] and its angle about the pipe [rad].
template <class Parameters>
void draw(const Parameters& p, double, std::span<const double> observed, Drawing& drawing) {
  const double L = p["L"], r = p["r"], phi = p["phi"], psi = observed[2];
  const double theta = std::atan2(observed[1], observed[0]), C = std::cos(theta), S = std::sin(theta);
  const Place center{observed[0], observed[1], L * std::cos(phi)};
  const Place along{std::sin(phi) * C, std::sin(phi) * S, std::cos(phi)}, across{-S, C, 0},
      down{std::cos(phi) * C, std::cos(phi) * S, -std::sin(phi)};
  const Place mark = center + r * (std::cos(psi) * down + std::sin(psi) * across);
  const Place below{center.x, center.y, 0};
  drawing.in_space();
  drawing.axis({}, {0.8 * L, 0, 0}, "x");
  drawing.axis({}, {0, 0.8 * L, 0}, "y");
  drawing.axis({}, {0, 0, L}, "z");
  drawing.guide(circle({0, 0, center.z}, L * std::sin(phi)));
  drawing.guide({{}, below, center});
  drawing.support({});
  drawing.rod({}, center);
  drawing.disc(center, r, "m", along);
  drawing.rope({center, mark});
  drawing.body(mark, L / 45);
  drawing.body_with_trail(center, L / 60);
  drawing.arrow(center, center + Place{0.4 * L, 0, 0}, "f");
  drawing.angle({}, {0, 0, 0.5 * L}, center, "φ");
  drawing.angle({}, {0.5 * L, 0, 0}, below, "θ");
  drawing.length({}, center, "L");
  drawing.length(center, center - r * down, "r");
}

}  // namespace oddity::pipe_and_disk
