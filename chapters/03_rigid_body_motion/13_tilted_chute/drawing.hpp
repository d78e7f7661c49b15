#pragma once

#include <cmath>
#include <span>

#include "chapters/03_rigid_body_motion/13_tilted_chute/models.hpp"
#include "chapters/drawing.hpp"

namespace oddity::tilted_chute {

/// Draws the ball in its chute; `observed` is its position [m]. The picture follows the ball down the axis.
template <class Parameters>
void draw(const Parameters& p, double t, std::span<const double> observed, Drawing& drawing) {
  const double R = p["R"], L = p["L"], H = p["H"];
  const Chute<double> chute{R, L, H};
  const auto at = [&](double along, double angle) {
    const auto x = chute.position(along, angle);
    return Place{x[0], x[1], x[2]};
  };
  const double now = Given<double>{R, L, H, p["g"], p["phi"], p["u"]}.along(t);
  const double top = now - 0.3 * L, end = top + L, half = std::numbers::pi / 2;
  const auto across = [&](double along) {
    return sampled(-half, half, 24, [&](double angle) { return at(along, angle); });
  };
  drawing.in_space();
  drawing.anchor(at(now, 0));
  for (int i = -3; i <= 3; ++i) drawing.track({at(top, i * half / 3), at(end, i * half / 3)});
  const double between = L / 5;
  drawing.track(across(top));
  drawing.track(across(end));
  for (double i = std::ceil(top / between); i * between < end; ++i) drawing.track(across(i * between));
  const Place ball{observed[0], observed[1], observed[2]}, above = at(now, half) - Place{0, R, 0};
  drawing.guide({at(top, half) - Place{0, R, 0}, at(end, half) - Place{0, R, 0}});
  drawing.body_with_trail(ball, R / 10);
  drawing.guide({above, ball});
  drawing.angle(above, at(now, 0), ball, "φ");
  drawing.length(above, at(now, -half), "R");
  drawing.length(at(end, -half), at(top, -half), "L");
  const Place high = at(top, half), low = at(end, half), corner{high.x, high.y, low.z};
  drawing.guide({high, corner, low});
  drawing.length(corner, high, "H");
}

}  // namespace oddity::tilted_chute
