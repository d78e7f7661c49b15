#pragma once

#include <array>
#include <cmath>

#include "chapters/03_rigid_body_motion/shared/height_field_models.hpp"

/// A particle on the frictionless hill x3 = -x1^2/a1^2 - x2^2/a2^2 (lengths over the metre).
namespace oddity::paraboloid_hill {

using height_field::Pair;

struct Hill {
  double a1, a2;

  template <class T>
  T height(const T& x1, const T& x2) const {
    return -(x1 * x1 / T(a1 * a1)) - x2 * x2 / T(a2 * a2);
  }
  Pair gradient(const Pair& x) const { return {-2 * x[0] / (a1 * a1), -2 * x[1] / (a2 * a2)}; }
  /// (Hessian of h) v.
  Pair turn(const Pair&, const Pair& v) const { return {-2 * v[0] / (a1 * a1), -2 * v[1] / (a2 * a2)}; }
  double bend(const Pair& x, const Pair& v) const {
    const Pair turned = turn(x, v);
    return v[0] * turned[0] + v[1] * turned[1];
  }
};

/// v1^2/a1^2 + v2^2/a2^2: half of what the hill bends down along v.
inline double steepening(const Hill& hill, const Pair& v) { return -hill.bend({0, 0}, v) / 2; }

/// A start at p with velocity v in the plane.
struct Case {
  Hill hill;
  double g;
  Pair p, v;
};

struct StraightLine : Case {
  std::array<double, 3> at(double t) const {
    const double x1 = p[0] + v[0] * t, x2 = p[1] + v[1] * t;
    return {x1, x2, hill.height(x1, x2)};
  }
};

/// (x1, x2, x3, x1', x2', x3'); the hill's force along (2 x1/a1^2, 2 x2/a2^2, 1) keeps the point on it.
struct InSpace : Case {
  using State = std::array<double, 6>;
  State start() const {
    const Pair n = hill.gradient(p);
    return {p[0], p[1], hill.height(p[0], p[1]), v[0], v[1], n[0] * v[0] + n[1] * v[1]};
  }
  void operator()(const State& x, State& dxdt, double) const {
    const double n1 = 2 * x[0] / (hill.a1 * hill.a1), n2 = 2 * x[1] / (hill.a2 * hill.a2);
    const double force = (g + hill.bend({}, {x[3], x[4]})) / (n1 * n1 + n2 * n2 + 1);
    dxdt = {x[3], x[4], x[5], force * n1, force * n2, force - g};
  }
  std::array<double, 3> observe(const State& x, double) const { return {x[0], x[1], x[2]}; }
  auto conserved(const State& x, double) const {
    return energy_of((x[3] * x[3] + x[4] * x[4] + x[5] * x[5]) / 2, g * x[2]);
  }
  /// Upright: the hill itself may be nearer.
  double off_constraint(const State& x, double) const { return std::abs(x[2] - hill.height(x[0], x[1])); }
};

inline height_field::InPlane<Hill> in_plane(const Case& c) {
  return {c.hill, c.g, {c.p[0], c.p[1], c.v[0], c.v[1]}};
}

inline height_field::Momenta<Hill> in_momenta(const Case& c) { return {c.hill, c.g, in_plane(c).first}; }

/// The speed along v with which the line is straight.
inline Case at_the_right_speed(Case c) {
  const double factor = std::sqrt(c.g / (2 * steepening(c.hill, c.v)));
  for (double& v : c.v) v *= factor;
  return c;
}

inline Case times(Case c, double factor) {
  for (double& v : c.v) v *= factor;
  return c;
}

/// From the top along v, at `factor` times the speed with which the line is straight.
inline Case from_the_top(const Hill& hill, double g, const Pair& v, double factor) {
  return times(at_the_right_speed({hill, g, {0, 0}, v}), factor);
}

}  // namespace oddity::paraboloid_hill
