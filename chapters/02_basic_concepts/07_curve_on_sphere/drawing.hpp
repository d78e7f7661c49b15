#pragma once

#include <cmath>
#include <cstddef>
#include <span>

#include "chapters/02_basic_concepts/07_curve_on_sphere/models.hpp"
#include "chapters/drawing.hpp"

namespace oddity::curve_on_sphere {

/// Draws the frame on its sphere; `observed` is the matrix [r u r x u], row by row.
template <class Parameters>
void draw(const Parameters& p, double, std::span<const double> observed, Drawing& drawing) {
  const auto column = [&](std::size_t i) { return Place{observed[i], observed[3 + i], observed[6 + i]}; };
  const Place r = column(0);
  drawing.in_space();
  drawing.sphere({}, 1);
  drawing.guide(circle({}, 1));
  drawing.axis({}, {1.5, 0, 0}, "x");
  drawing.axis({}, {0, 1.35, 0}, "y");
  drawing.axis({}, {0, 0, 1.35}, "z");
  drawing.track(sampled(0, std::fmin(4 * p["pace"], 5), 240, [](double t) {
    const auto x = position(t);
    return Place{x[0], x[1], x[2]};
  }));
  drawing.arrow({}, r, "r");
  drawing.arrow(r, r + 0.5 * column(1), "u");
  drawing.arrow(r, r + 0.5 * column(2), "r × u");
  drawing.body_with_trail(r, 0.03);
}

}  // namespace oddity::curve_on_sphere
