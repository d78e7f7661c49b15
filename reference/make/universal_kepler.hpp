#pragma once

#include <algorithm>
#include <limits>

#include "reference/make/routes.hpp"

/// A body's path about a fixed center with the attraction mu/r^2, by Kepler's equation in universal variables
/// [Bate, Mueller, White, Fundamentals of Astrodynamics, ch. 4]. With z = alpha chi^2, alpha = 2/r0 -
/// v0^2/mu:
///   sqrt(mu) t = chi^3 C3(z) + s chi^2 C2(z) + r0 chi (1 - z C3(z)),   s = r0 . v0/sqrt(mu),
/// with Stumpff's functions C2, C3. It holds for ellipse, parabola and hyperbola, and needs no perihelion.
namespace oddity::truth {

/// C_k(z) = sum over j of (-z)^j / (2j + k)!, k = 2 or 3; for small z each term is less than half the
/// previous one.
inline Number stumpff(int k, const Number& z) {
  if (abs(z) > 1) {
    const Number w = sqrt(abs(z)), s = z > 0 ? sin(w) : sinh(w), c = z > 0 ? cos(w) : cosh(w);
    return k == 2 ? Number((1 - c) / z) : Number((w - s) / (z * w));
  }
  Number term = k == 2 ? Number(1) / 2 : Number(1) / 6, sum = term;
  for (int j = 1; abs(term) > pow(Number(10), -65); ++j) {
    term *= -z / ((2 * j + k - 1) * (2 * j + k));
    sum += term;
  }
  return within(sum, abs(term));
}

/// Position and velocity in the plane.
struct Orbiter {
  Number x, y, vx, vy;
};

/// The position at the time t > 0 after the start.
inline Numbers by_universal_kepler(const Number& mu, const Orbiter& a, const Number& t, int digits) {
  const Number root = sqrt(mu), r0 = sqrt(a.x * a.x + a.y * a.y);
  const Number s = (a.x * a.vx + a.y * a.vy) / root, alpha = 2 / r0 - (a.vx * a.vx + a.vy * a.vy) / mu;
  const auto time = [&](const Number& chi) -> Number {
    const Number z = alpha * chi * chi, c3 = stumpff(3, z);
    return (chi * chi * chi * c3 + s * chi * chi * stumpff(2, z) + r0 * chi * (1 - z * c3)) / root;
  };
  const Number close =
      std::max<Number>(pow(Number(10), -digits - 8), 2 * std::numeric_limits<Number>::epsilon());
  Number low = 0, high = 1;
  while (time(high) < t) high *= 2;
  while (high - low > high * close) {
    const Number middle = (low + high) / 2;
    (time(middle) < t ? low : high) = middle;
  }
  const Number chi = between(low, high), z = alpha * chi * chi;
  const Number f = 1 - chi * chi * stumpff(2, z) / r0, g = t - chi * chi * chi * stumpff(3, z) / root;
  return {f * a.x + g * a.vx, f * a.y + g * a.vy};
}

}  // namespace oddity::truth
