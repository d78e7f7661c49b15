#pragma once

#include <algorithm>
#include <limits>
#include <type_traits>

#include "reference/make/routes.hpp"

/// A body's path about a fixed center with the attraction mu/r^2, by Kepler's equation in universal variables
/// [Bate, Mueller, White, Fundamentals of Astrodynamics, ch. 4]. With z = alpha chi^2, alpha = 2/r0 -
/// v0^2/mu:
///   sqrt(mu) t = chi^3 C3(z) + s chi^2 C2(z) + r0 chi (1 - z C3(z)),   s = r0 . v0/sqrt(mu),
/// with the slope r, and Stumpff's functions C2, C3. It holds for ellipse, parabola and hyperbola, and needs
/// no perihelion.
namespace oddity::truth {

/// C_k(z) = sum over j of (-z)^j / (2j + k)!, k = 2 or 3, where each term is less than half the previous one.
inline Number stumpff_series(int k, const Number& z) {
  Number term = k == 2 ? Number(1) / 2 : Number(1) / 6, sum = term;
  for (int j = 1; abs(term) > 1e-65; ++j) {
    term *= -z / ((2 * j + k - 1) * (2 * j + k));
    sum += term;
  }
  return within(sum, abs(term));
}

/// Stumpff's functions at one argument.
struct Stumpff {
  Number c2, c3;

  explicit Stumpff(const Number& z) {
    if (abs(z) <= 1) {
      c2 = stumpff_series(2, z);
      c3 = stumpff_series(3, z);
    } else {
      const Number w = sqrt(abs(z)), s = z > 0 ? sin(w) : sinh(w), c = z > 0 ? cos(w) : cosh(w);
      c2 = (1 - c) / z;
      c3 = (w - s) / (z * w);
    }
  }
};

/// Position and velocity in the plane.
struct Orbiter {
  Number x, y, vx, vy;
};

/// Time after the start, and its slope.
struct Moment {
  Number time, slope;
};

/// The chi at which the time is t, by bisection to the last digits.
template <class At>
Number halved(const At& moment, const Number& t, Number low, Number high, int digits) {
  const Number close =
      std::max<Number>(pow(Number(10), -digits - 8), 2 * std::numeric_limits<Number>::epsilon());
  while (high - low > high * close) {
    const Number middle = (low + high) / 2;
    (moment(middle).time < t ? low : high) = middle;
  }
  return between(low, high);
}

/// That chi by Newton's method, each step within the bracket.
template <class At>
Number by_newton(const At& moment, const Number& t, Number low, Number high) {
  Number chi = (low + high) / 2, moved = chi;
  while (abs(moved) > 4 * std::numeric_limits<Number>::epsilon() * chi) {
    const Moment here = moment(chi);
    (here.time < t ? low : high) = chi;
    Number next = chi + (t - here.time) / here.slope;
    if (!(low < next && next < high)) next = (low + high) / 2;
    moved = next - chi;
    chi = next;
  }
  return chi;
}

/// The position at the time t > 0 after the start.
inline Numbers by_universal_kepler(const Number& mu, const Orbiter& a, const Number& t, int digits) {
  const Number root = sqrt(mu), r0 = sqrt(a.x * a.x + a.y * a.y);
  const Number s = (a.x * a.vx + a.y * a.vy) / root, alpha = 2 / r0 - (a.vx * a.vx + a.vy * a.vy) / mu;
  const auto moment = [&](const Number& chi) -> Moment {
    const Number z = alpha * chi * chi;
    const Stumpff at(z);
    return {(chi * chi * chi * at.c3 + s * chi * chi * at.c2 + r0 * chi * (1 - z * at.c3)) / root,
            (chi * chi * at.c2 + s * chi * (1 - z * at.c3) + r0 * (1 - z * at.c2)) / root};
  };
  // Motions in the processor's own numbers are asked for at thousands of frames.
  constexpr bool is_quick = std::is_floating_point_v<Number>;
  Number low = 0, high = 1;
  if (is_quick && alpha > 0) {  // an ellipse, whose eccentric and mean anomalies differ by less than 1
    const Number mean = root * alpha * t, apart = 2 / sqrt(alpha);
    low = std::max<Number>(0, mean - apart);
    high = mean + apart;
  } else {
    while (moment(high).time < t) high *= 2;
  }
  const Number chi = is_quick ? by_newton(moment, t, low, high) : halved(moment, t, low, high, digits);
  const Stumpff at(alpha * chi * chi);
  const Number f = 1 - chi * chi * at.c2 / r0, g = t - chi * chi * chi * at.c3 / root;
  return {f * a.x + g * a.vx, f * a.y + g * a.vy};
}

}  // namespace oddity::truth
