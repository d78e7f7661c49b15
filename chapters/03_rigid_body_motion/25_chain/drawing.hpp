#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>

#include "chapters/drawing.hpp"

namespace oddity::chain {

/// Draws the three masses; `observed` are their positions [m], starting at the pivot.
template <class Parameters>
void draw(const Parameters& p, double, std::span<const double> observed, Drawing& drawing) {
  constexpr std::string_view masses[] = {"m1", "m2", "m3"}, rods[] = {"r1", "r2", "r3"},
                             angles[] = {"θ1", "θ2", "θ3"};
  const double h = p["h"], all = p["r1"] + p["r2"] + p["r3"];
  Place above{0, h};
  drawing.support(above + Place{0.15 * all, 0}, above - Place{0.15 * all, 0});
  drawing.support(above);
  for (std::size_t k = 0; k < 3; ++k) {
    const Place mass{observed[2 * k], observed[2 * k + 1]};
    const double size = all / 30 * std::cbrt(p[masses[k]] / p["m1"]);
    drawing.rod(above, mass);
    if (k == 2)
      drawing.body_with_trail(mass, size, masses[k]);
    else
      drawing.body(mass, size, masses[k]);
    drawing.angle(above, above - Place{0, 0.75 * p[rods[k]]}, mass, angles[k]);
    drawing.length(above, mass, rods[k]);
    above = mass;
  }
  if (h > 0 && h < 2 * all) {
    drawing.axis({-0.4 * all, 0}, {0.5 * all, 0}, "x");
    drawing.length({-0.3 * all, 0}, {-0.3 * all, h}, "h");
  }
}

}  // namespace oddity::chain
