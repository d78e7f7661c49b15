#pragma once

#include <cmath>
#include <span>
#include <string_view>
#include <vector>

#include "chapters/drawing.hpp"

namespace oddity::two_pulleys {

/// Draws the machine; `observed` are the depths of the small pulley and of the mass below the level 0 [m].
template <class Parameters>
void draw(const Parameters& p, double, std::span<const double> observed, Drawing& drawing) {
  const double R1 = p["R1"], R2 = p["R2"], y2 = observed[0], y3 = observed[1];
  const double S1 = y2 + p["K1"], S2 = y3 - 2 * y2 + p["K2"];
  // Depths at rest, with enough room around them to keep pulleys, springs and floor apart.
  const double rest2 = p["L1"] - p["K1"] + (p["m2"] + 2 * p["m3"]) * p["g"] / p["c1"],
               rest3 = p["L2"] - p["K2"] + p["m3"] * p["g"] / p["c2"] + 2 * rest2;
  const double high = std::fmin(p["y2"], rest2), low2 = std::fmax(p["y2"], rest2),
               low3 = std::fmax(p["y3"], rest3), room = 0.2 * (R1 + R2);
  const double y1 = std::fmin(1.4 * R1, high - 1.15 * (R1 + R2)), ceiling = y1 - 1.4 * R1;
  const double floor = std::fmax(low2 + p["K1"] + y1 + R1, low3 + 2 * R2) + 2 * room;
  const Place large{0, -y1}, small{R1, -y2}, mass{R1 + R2, -y3}, end1{-R1, S1 - floor},
      end2{R1 - R2, S2 - floor};
  const auto over = [](const Place& center, double radius) {
    return [center, radius](double angle) {
      return center + radius * Place{std::cos(angle), std::sin(angle)};
    };
  };
  const auto rope = [&](const Place& from, const Place& center, double radius, const Place& to) {
    std::vector<Place> through{from};
    for (const Place& x : sampled(std::numbers::pi, 0, 24, over(center, radius))) through.push_back(x);
    through.push_back(to);
    drawing.rope(through);
  };
  const auto pulley = [&](const Place& center, double radius, double turned, std::string_view letter) {
    drawing.disc(center, radius, letter);
    const auto rim = over(center, 0.8 * radius);
    drawing.rope({rim(-turned), rim(std::numbers::pi - turned)});
  };
  const double left = -R1 - 2 * room, right = R1 + R2 + 4 * room;
  drawing.support({right, -ceiling}, {left, -ceiling});
  drawing.support({left, -floor}, {right, -floor});
  drawing.guide({{left, 0}, {right, 0}});
  drawing.rod({0, -ceiling}, large);
  drawing.spring({-R1, -floor}, end1, room, "c1");
  drawing.spring({R1 - R2, -floor}, end2, room, "c2");
  pulley(large, R1, y2 / R1, "I1");
  pulley(small, R2, (y3 - y2) / R2, "m2");
  rope(end1, large, R1, small);
  rope(end2, small, R2, mass);
  drawing.support(large);
  drawing.body(small, 0.12 * R2);
  const double w = 0.6 * room, h = 1.2 * room;
  drawing.plate({mass + Place{-w, 0}, mass + Place{w, 0}, mass + Place{w, -h}, mass + Place{-w, -h}}, "m3");
  drawing.length({right - 2 * room, -y2}, {right - 2 * room, 0}, "y2");
  drawing.length({right, -y3}, {right, 0}, "y3");
  drawing.label({left, 0}, "0");
}

}  // namespace oddity::two_pulleys
