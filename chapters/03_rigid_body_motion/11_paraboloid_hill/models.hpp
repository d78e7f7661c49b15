#pragma once

#include <array>
#include <tuple>

#include "chapters/03_rigid_body_motion/shared/height_field_models.hpp"

/// The models of exercise 3.11: a particle on the frictionless hill x3 = -x1^2/a1^2 - x2^2/a2^2 (lengths in
/// metres). The observables are the position.
namespace oddity::paraboloid_hill {

/// The exercise's parameters: from the top along (v1, v2), at `factor` times the speed that makes the path
/// straight.
template <class T>
struct Given {
  T a1, a2, g, v1, v2, factor;
};

template <class T>
struct Hill {
  T a1, a2;

  template <class X>
  X height(const X& x1, const X& x2) const {
    return -(x1 * x1 / (a1 * a1)) - x2 * x2 / (a2 * a2);
  }
  template <class X>
  std::array<X, 2> gradient(const std::array<X, 2>& x) const {
    return {-2 * x[0] / (a1 * a1), -2 * x[1] / (a2 * a2)};
  }
  /// (Hessian of h) v.
  template <class X>
  std::array<X, 2> turn(const std::array<X, 2>&, const std::array<X, 2>& v) const {
    return {-2 * v[0] / (a1 * a1), -2 * v[1] / (a2 * a2)};
  }
  template <class X>
  X bend(const std::array<X, 2>& x, const std::array<X, 2>& v) const {
    const auto turned = turn(x, v);
    return v[0] * turned[0] + v[1] * turned[1];
  }
};

/// v1^2/a1^2 + v2^2/a2^2: half of the hill's downward second derivative along v.
template <class T>
T steepening(const Hill<T>& hill, const std::array<T, 2>& v) {
  return -hill.bend(v, v) / 2;
}

/// Initial condition: at p with velocity v in the plane.
template <class T>
struct Case {
  Hill<T> hill;
  T g;
  std::array<T, 2> p, v;
};

template <class T>
Case<T> from_the_top(const Given<T>& given) {
  Case<T> start{{given.a1, given.a2}, given.g, {T(0), T(0)}, {given.v1, given.v2}};
  const T right = sqrt(start.g / (2 * steepening(start.hill, start.v)));
  for (T& v : start.v) v = v * right * given.factor;
  return start;
}

template <class T>
struct StraightLine {
  Case<T> of;
  std::array<T, 3> at(const T& t) const {
    const T x1 = of.p[0] + of.v[0] * t, x2 = of.p[1] + of.v[1] * t;
    return {x1, x2, of.hill.height(x1, x2)};
  }
};

template <class T>
using InPlane = height_field::InPlane<T, Hill<T>>;
template <class T>
InPlane<T> in_plane(const Case<T>& c) {
  return {c.hill, c.g, {c.p[0], c.p[1], c.v[0], c.v[1]}};
}

template <class T>
using Momenta = height_field::Momenta<T, Hill<T>>;
template <class T>
Momenta<T> in_momenta(const Case<T>& c) {
  return {c.hill, c.g, in_plane(c).first};
}

/// (x1, x2, x3, x1', x2', x3'); the hill's force along (2 x1/a1^2, 2 x2/a2^2, 1) keeps the point on it.
template <class T>
struct InSpace {
  Case<T> of;
  using State = std::array<T, 6>;
  State start() const {
    const auto& [hill, g, p, v] = of;
    const auto n = hill.gradient(p);
    return {p[0], p[1], hill.height(p[0], p[1]), v[0], v[1], n[0] * v[0] + n[1] * v[1]};
  }
  template <class X>
  void operator()(const std::array<X, 6>& x, std::array<X, 6>& dxdt, const X&) const {
    const auto& [hill, g, p, v] = of;
    const X n1 = 2 * x[0] / (hill.a1 * hill.a1), n2 = 2 * x[1] / (hill.a2 * hill.a2);
    const std::array<X, 2> u{x[3], x[4]};
    const X force = (g + hill.bend(u, u)) / (n1 * n1 + n2 * n2 + 1);
    dxdt = {x[3], x[4], x[5], force * n1, force * n2, force - g};
  }
  std::array<T, 3> observe(const State& x, const T&) const { return {x[0], x[1], x[2]}; }
  auto conserved(const State& x, const T&) const {
    return energy_of<T>((x[3] * x[3] + x[4] * x[4] + x[5] * x[5]) / 2, of.g * x[2]);
  }
  /// Vertical distance; the hill itself may be nearer.
  std::array<T, 1> constraints(const State& x, const T&) const { return {x[2] - of.hill.height(x[0], x[1])}; }
};

/// From the simplest to the richest.
template <class T>
auto models(const Given<T>& p) {
  const Case<T> start = from_the_top(p);
  return std::tuple{StraightLine<T>{start}, in_plane(start), in_momenta(start), InSpace<T>{start}};
}

}  // namespace oddity::paraboloid_hill
