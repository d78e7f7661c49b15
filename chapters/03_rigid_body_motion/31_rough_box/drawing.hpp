#pragma once

#include <cmath>
#include <span>

#include "chapters/drawing.hpp"

namespace oddity::rough_box {

/// Draws the box from above; `observed` is its position [m] and its angle [rad].
template <class Parameters>
void draw(const Parameters& p, double, std::span<const double> observed, Drawing& drawing) {
  const double a = p["a"], b = p["b"], C = std::cos(observed[2]), S = std::sin(observed[2]);
  const auto at = [&](double x, double y) {
    return Place{observed[0] + C * x - S * y, observed[1] + S * x + C * y};
  };
  drawing.axis({-1.5 * a, 0}, {1.2 * a + 0.6, 0}, "x");
  drawing.axis({0, -1.5 * b}, {0, 1.5 * b + 0.2}, "y");
  drawing.plate({at(-a, -b), at(a, -b), at(a, b), at(-a, b)});
  drawing.rope({at(0.7 * a, -b), at(0.7 * a, b)});
  drawing.body_with_trail(at(0, 0), a / 18);
  drawing.length(at(a, -b), at(0, -b), "a");
  drawing.length(at(-a, -b), at(-a, 0), "b");
  drawing.direction(at(0, 0), at(0.2 * p["u0"], 0), "u0");
  drawing.direction(at(0, 0), at(0, 0.2 * p["v0"]), "v0");
}

}  // namespace oddity::rough_box
