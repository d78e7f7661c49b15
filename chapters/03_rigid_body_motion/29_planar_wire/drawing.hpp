#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "chapters/03_rigid_body_motion/29_planar_wire/models.hpp"
#include "chapters/drawing.hpp"

namespace oddity::planar_wire {

/// Draws the thrown wire; `observed` is the position of its mark [m], the end of the parabola at its vertex.
template <class Parameters>
void draw(const Parameters& p, double t, std::span<const double> observed, Drawing& drawing) {
  const double q = p["q"], u = p["u"], v = p["v"], g = p["g"];
  const auto b = thrown(Given<double>{q, p["d"], u, v, p["w"], g}).b;
  const auto flight = [&](double s) { return Place{u * s, v * s - g * s * s / 2}; };
  // Rotated so that the mark is at its observed position relative to the center.
  const Place mark{observed[0], observed[1]}, seen = mark - flight(t);
  const double turned = std::atan2(seen.y, seen.x) - std::atan2(b[1], b[0]);
  const double C = std::cos(turned), S = std::sin(turned);
  const auto at = [&](double x, double y) { return mark + Place{C * x - S * y, S * x + C * y}; };
  const Place center = at(-b[0], -b[1]);
  drawing.guide(sampled(0, 2 * q / std::fmax(std::hypot(u, v), 0.1 * q), 32, flight));
  const auto wire = sampled(0, q, 32, [&](double x) { return at(x, x * x); });
  for (std::size_t i = 0; i + 1 < wire.size(); ++i) drawing.rod(wire[i], wire[i + 1]);
  drawing.disc(center, q / 30);
  drawing.body_with_trail(mark, q / 18);
  drawing.length(at(q, 0), at(0, 0), "q");
  drawing.direction(center, center + Place{0.2 * u, 0}, "u");
  drawing.direction(center, center + Place{0, 0.2 * v}, "v");
}

}  // namespace oddity::planar_wire
