#pragma once

#include "reference/make/routes.hpp"

/// A uniform wire of size q and density d. Shape 0: from (0, 0) to (q, 0); 1: the upper half circle of radius
/// q; 2: y = x^2 from 0 to q.
namespace oddity::truth::wire {

enum Shape { straight, semicircle, parabola };

/// mu0, the center of mass, and mu2 about it.
struct Inertia {
  Number mu0, x, y, mu2;
  Inertia(const Number& m, const Number& mx, const Number& my, const Number& m2)
      : mu0(m), x(mx / m), y(my / m), mu2(m2 - (mx * mx + my * my) / m) {}
};

/// By the primitives of ds, x ds, y ds and (x^2 + y^2) ds; on the parabola ds = sqrt(1 + 4 x^2) dx.
inline Inertia by_primitives(int shape, const Number& q, const Number& d) {
  if (shape == straight) return {d * q, d * q * q / 2, 0, d * q * q * q / 3};
  if (shape == semicircle) return {pi() * q * d, 0, 2 * q * q * d, pi() * q * q * q * d};
  const Number q2 = q * q, root = sqrt(1 + 4 * q2), log_end = log(2 * q + root);
  const Number length = q * root / 2 + log_end / 4;
  const Number second = q * root * (1 + 8 * q2) / 32 - log_end / 64;    // x^2 ds
  const Number fourth = q * q2 * root * root * root / 24 - second / 8;  // x^4 ds
  return {d * length, d * (root * root * root - 1) / 12, d * second, d * (second + fourth)};
}

/// By quadrature over the angle from the x axis, along the curve as seen from the origin, or over the height.
inline Inertia by_quadrature(int shape, const Number& q, const Number& d, Precision digits) {
  const auto moments = [&](const auto& x, const auto& y, const auto& ds, const Number& a, const Number& b) {
    const auto of = [&](const auto& f) {
      return integral([&](const Number& u) -> Number { return d * f(x(u), y(u)) * ds(u); }, a, b, digits);
    };
    return Inertia(of([](const Number&, const Number&) -> Number { return 1; }),
                   of([](const Number& X, const Number&) -> Number { return X; }),
                   of([](const Number&, const Number& Y) -> Number { return Y; }),
                   of([](const Number& X, const Number& Y) -> Number { return X * X + Y * Y; }));
  };
  const auto zero = [](const Number&) -> Number { return 0; };
  const auto itself = [](const Number& u) -> Number { return u; };
  if (shape == straight)
    return moments(
        itself, zero, [](const Number&) -> Number { return 1; }, 0, q);
  if (shape == semicircle)
    return moments([&](const Number& t) -> Number { return q * cos(t); },
                   [&](const Number& t) -> Number { return q * sin(t); },
                   [&](const Number&) -> Number { return q; }, 0, pi());
  return moments([](const Number& y) -> Number { return sqrt(y); }, itself,
                 [](const Number& y) -> Number { return sqrt(1 + 1 / (4 * y)); }, 0, Number(q * q));
}

}  // namespace oddity::truth::wire
