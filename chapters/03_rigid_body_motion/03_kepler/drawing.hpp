#pragma once

#include <cmath>
#include <span>

#include "chapters/drawing.hpp"

namespace oddity::kepler {

/// Draws the planet and its orbit; `observed` is the planet's position [AU], with the sun at the origin.
template <class Parameters>
void draw(const Parameters& p, double, std::span<const double> observed, Drawing& drawing) {
  const double r0 = p["r0"], mu = p["G"] * p["M"], start = p["theta0"];
  const Place planet{observed[0], observed[1]}, first{r0 * std::cos(start), r0 * std::sin(start)};
  const Place across{-first.y, first.x};
  const double turn = p["theta0_dot"], h = r0 * r0 * turn, rate = p["r0_dot"];
  // The part of the orbit r = q/(1 + e cos nu) that stays near.
  const double q = h * h / mu, e_cos = q / r0 - 1, e_sin = rate * h / mu, e = std::hypot(e_cos, e_sin);
  const double least = q / (6 * r0) - 1, nu0 = std::atan2(e_sin, e_cos);
  const double end = least > -e ? std::acos(std::fmax(-1, std::fmin(1, least / e))) : std::numbers::pi;
  drawing.track(sampled(-end, end, 120, [&](double nu) {
    // On a very eccentric orbit the angle's roundings change the distance considerably.
    const double r = q / std::fmax(1 + e * std::cos(nu), q / (6 * r0)), angle = start + nu - nu0;
    return Place{r * std::cos(angle), r * std::sin(angle)};
  }));
  drawing.guide({{}, planet});
  drawing.sphere({}, r0 / 12);
  drawing.support({});
  drawing.label({0.07 * r0, -0.07 * r0}, "M");
  drawing.body_with_trail(planet, r0 / 28);
  drawing.angle({}, {0.5 * r0, 0}, first, "θ0");
  drawing.length({}, first, "r0");
  drawing.direction(first, first + 0.06 * (turn * across + rate / r0 * first), "v");
}

}  // namespace oddity::kepler
