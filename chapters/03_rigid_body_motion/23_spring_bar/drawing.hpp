#pragma once

#include <cmath>
#include <span>

#include "chapters/drawing.hpp"

namespace oddity::spring_bar {

/// Draws the bar on its spring; `observed` is the position of the mass [m].
template <class Parameters>
void draw(const Parameters& p, double, std::span<const double> observed, Drawing& drawing) {
  const double r = p["r"], s = p["s"], h = p["h"], size = std::fmax(r, s);
  const double theta = std::atan2(observed[1], observed[0]);
  const auto at = [&](double along) { return along * Place{std::cos(theta), std::sin(theta)}; };
  const Place foot{s, -h};
  drawing.support(foot - Place{0.3 * size, 0}, foot + Place{0.3 * size, 0});
  drawing.guide({{}, {1.15 * size, 0}});
  drawing.spring(foot, at(s), size / 12, "c");
  drawing.rod({}, at(s));
  drawing.rod(at(s), at(size));
  drawing.support({});
  drawing.body_with_trail({observed[0], observed[1]}, size / 18, "m");
  drawing.angle({}, {0.6 * size, 0}, at(1), "θ0");
  drawing.length({}, at(r), "r");
  drawing.length({s, 0}, {}, "s");
  drawing.length({s, 0}, foot, "h");
}

}  // namespace oddity::spring_bar
