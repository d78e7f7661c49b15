#pragma once

#include <cmath>
#include <span>

#include "chapters/drawing.hpp"

namespace oddity::heavy_top {

/// Draws a top with its tip at `tip` and its axis in the direction `axis`, of length 1.
template <class Parameters>
void draw_top(const Parameters& p, const Place& tip, const Place& axis, Drawing& drawing) {
  const double l = p["l"], end = 2 * l, phi = p["phi"], theta = p["theta"];
  const double rim = l * std::fmax(0.3, std::fmin(1.2, std::sqrt(2 * p["mu3"] / p["m"]) / l));
  const auto at = [&](double along) { return tip + along * axis; };
  const Place nodes{std::cos(theta), std::sin(theta), 0};
  drawing.sphere(tip, end);
  drawing.guide(circle(tip + Place{0, 0, end * std::cos(phi)}, end * std::sin(phi)));
  drawing.axis(tip, tip + Place{0, 0, 1.25 * end}, "z");
  drawing.guide({tip, tip + end * nodes});
  drawing.rod(tip, at(end));
  drawing.disc(at(l), rim, "m", axis);
  drawing.body(at(l), l / 30);
  drawing.body_with_trail(at(end), l / 18);
  drawing.support(tip);
  drawing.angle(tip, tip + Place{0, 0, end}, at(end), "φ");
  drawing.angle(tip, tip + Place{end, 0, 0}, tip + end * nodes, "θ");
  drawing.length(at(l), tip, "ℓ");
}

/// Draws the top; `observed` is the direction of its axis.
template <class Parameters>
void draw(const Parameters& p, double, std::span<const double> observed, Drawing& drawing) {
  const double size = 2.5 * p["l"];
  drawing.in_space();
  drawing.axis({}, {size, 0, 0}, "x");
  drawing.axis({}, {0, size, 0}, "y");
  draw_top(p, {}, {observed[0], observed[1], observed[2]}, drawing);
}

}  // namespace oddity::heavy_top
