#pragma once

#include "reference/make/even_limit.hpp"
#include "reference/make/routes.hpp"

/// r = ((1 - t^2) cos(pi t), (1 - t^2) sin(pi t), t^2)/sqrt(d), d = (1 - t^2)^2 + t^4. The curve and its
/// frame [r u r x u], u = r'/|r'|, are computed by two routes.
namespace oddity::truth::curve_on_sphere {

/// Latitude psi and longitude pi t of r: cos(psi) = (1 - t^2)/sqrt(d), of any sign, sin(psi) = t^2/sqrt(d).
struct Angles {
  Number cosine, sine, rate, rate_dot;  ///< cos(psi), sin(psi), psi', psi''
  Vector r, north, east;  ///< unit vectors: position, along growing psi, along growing longitude

  explicit Angles(const Number& t) {
    const Number d = (1 - t * t) * (1 - t * t) + t * t * t * t, d_dot = 4 * t * (2 * t * t - 1);
    cosine = (1 - t * t) / sqrt(d), sine = t * t / sqrt(d);
    rate = 2 * t / d, rate_dot = (2 * d - 2 * t * d_dot) / (d * d);
    const Number c = cos_pi(t), s = sin_pi(t);
    r = {cosine * c, cosine * s, sine};
    north = {-sine * c, -sine * s, cosine};
    east = {-s, c, 0};
  }
};

/// Rows of [r u r x u].
inline Matrix rows(const Vector& r, const Vector& u) {
  const Vector b = cross(r, u);
  return {Vector{r[0], u[0], b[0]}, Vector{r[1], u[1], b[1]}, Vector{r[2], u[2], b[2]}};
}

inline Matrix frame_by_angles(const Number& t) {
  const Angles a(t);
  const Vector v = sum(scaled(a.rate, a.north), scaled(pi() * a.cosine, a.east));
  return rows(a.r, scaled(1 / sqrt(dot(v, v)), v));
}

inline Vector position(const Number& t) {
  const Number s = t * t, c = 1 - s;
  return scaled(1 / sqrt(c * c + s * s), Vector{c * cos_pi(t), c * sin_pi(t), s});
}
/// The frame from positions alone.
inline Matrix frame_by_positions(const Number& t, int digits) {
  const Numbers v = even_limit(
      [&](const Number& h) {
        return numbers(scaled(1 / (2 * h), sum(position(t + h), scaled(-1, position(t - h)))));
      },
      digits);
  const Vector V{v[0], v[1], v[2]};
  return rows(position(t), scaled(1 / sqrt(dot(V, V)), V));
}

}  // namespace oddity::truth::curve_on_sphere
