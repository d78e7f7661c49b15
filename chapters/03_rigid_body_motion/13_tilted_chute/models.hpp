#pragma once

#include <array>
#include <cmath>

#include "chapters/03_rigid_body_motion/shared/height_field_models.hpp"

/// A ball in a cylindrical chute whose axis falls: its models, whose observables are the position.
namespace oddity::tilted_chute {

using height_field::Pair;
using Point = std::array<double, 3>;

/// Radius R; the axis falls by H over its length L. e = (c, 0, -s) down the axis, n = (s, 0, c) normal to it.
struct Chute {
  double R, L, H;

  double c() const { return std::sqrt((L - H) * (L + H)) / L; }
  double s() const { return H / L; }

  /// Where the distance `along` down the axis and the angle phi about it lead, from the origin.
  template <class T>
  std::array<T, 3> position(const T& along, const T& phi) const {
    using std::cos, std::sin;
    const T up = T(R) * (T(1.0) - cos(phi));
    return {along * T(c()) + up * T(s()), T(R) * sin(phi), up * T(c()) - along * T(s())};
  }

  // The same as a height field.
  template <class T>
  T height(const T& x1, const T& x2) const {
    using std::sqrt;
    return (T(R) - T(s()) * x1 - sqrt(T(R * R) - x2 * x2)) / T(c());
  }
  double depth(double x2) const { return std::sqrt((R - x2) * (R + x2)); }
  Pair gradient(const Pair& x) const { return {-s() / c(), x[1] / (depth(x[1]) * c())}; }
  Pair turn(const Pair& x, const Pair& v) const {
    const double d = depth(x[1]);
    return {0, R * R * v[1] / (d * d * d * c())};
  }
  double bend(const Pair& x, const Pair& v) const { return v[1] * turn(x, v)[1]; }
};

/// Let go at the angle phi from the lowest line, with the speed u down the axis.
struct Case {
  Chute chute;
  double g, phi, u;

  double along(double t) const { return u * t + g * chute.s() * t * t / 2; }
  double square() const { return g * chute.c() / chute.R; }
};

/// The book's: x2 = 0.
struct CenterLine : Case {
  Point at(double t) const {
    const double theta = std::asin(chute.H / chute.L);
    const double x1 = chute.position(0.0, phi)[0] + u * chute.c() * t + g * std::sin(2 * theta) / 4 * t * t;
    return {x1, 0, chute.height(x1, 0.0)};
  }
};

struct SmallAngle : Case {
  Point at(double t) const { return chute.position(along(t), phi * std::cos(std::sqrt(square()) * t)); }
};

/// (phi, phi'); the way along the axis in closed form.
struct Angle : Case {
  using State = std::array<double, 2>;
  State start() const { return {phi, 0}; }
  void operator()(const State& x, State& dxdt, double) const { dxdt = {x[1], -square() * std::sin(x[0])}; }
  void acceleration(const std::array<double, 1>& q, std::array<double, 1>& dv) const {
    dv = {-square() * std::sin(q[0])};
  }
  Point observe(const State& x, double t) const { return chute.position(along(t), x[0]); }
  auto conserved(const State& x, double) const {
    return energy_of(x[1] * x[1] / 2, square() * (1 - std::cos(x[0])));
  }
};

/// (x1, x2, x3, x1', x2', x3') with the chute's force along the way to its axis.
struct InSpace : Case {
  using State = std::array<double, 6>;
  State start() const {
    const Point x = chute.position(0.0, phi);
    return {x[0], x[1], x[2], u * chute.c(), 0, -u * chute.s()};
  }
  void operator()(const State& x, State& dxdt, double) const {
    const double c = chute.c(), s = chute.s(), z = x[2] - chute.R / c;
    const double way = c * x[0] - s * z, speed = c * x[3] - s * x[5];
    const double n1 = x[0] - way * c, n2 = x[1], n3 = z + way * s;
    const double w1 = x[3] - speed * c, w2 = x[4], w3 = x[5] + speed * s;
    const double m = (g * n3 - w1 * w1 - w2 * w2 - w3 * w3) / (n1 * n1 + n2 * n2 + n3 * n3);
    dxdt = {x[3], x[4], x[5], m * n1, m * n2, m * n3 - g};
  }
  Point observe(const State& x, double) const { return {x[0], x[1], x[2]}; }
  auto conserved(const State& x, double) const {
    return energy_of((x[3] * x[3] + x[4] * x[4] + x[5] * x[5]) / 2, g * x[2]);
  }
  /// Of the distance R from the axis.
  double off_constraint(const State& x, double) const {
    const double c = chute.c(), s = chute.s(), z = x[2] - chute.R / c, way = c * x[0] - s * z;
    return std::abs(std::hypot(x[0] - way * c, x[1], z + way * s) - chute.R);
  }
};

using InPlane = height_field::InPlane<Chute>;

inline InPlane in_plane(const Case& c) {
  const Point x = c.chute.position(0.0, c.phi);
  return {c.chute, c.g, {x[0], x[1], c.u * c.chute.c(), 0}};
}

}  // namespace oddity::tilted_chute
