#pragma once

#include <array>
#include <tuple>

#include "chapters/numbers.hpp"

/// The models of exercise 3.29: a rigid wire thrown in the plane.
namespace oddity::planar_wire {

template <class T>
using Point = std::array<T, 2>;

/// The center of mass, and the angle.
template <class T>
using Pose = std::array<T, 3>;

/// mu0, the center of mass, mu2 about it.
template <class T>
using Inertia = std::array<T, 4>;

/// From mu0 and the moments int x, int y, int (x^2 + y^2).
template <class T>
Inertia<T> about_center(const T& m0, const T& mx, const T& my, const T& m2) {
  const T cx = mx / m0, cy = my / m0;
  return {m0, cx, cy, m2 - m0 * (cx * cx + cy * cy)};
}

/// Inertia of y = x^2 from 0 to q with the uniform density d, from antiderivatives of the moments.
template <class T>
Inertia<T> inertia_of_parabola(const T& q, const T& d) {
  const T z = 2 * q, root = sqrt(1 + z * z), arsinh = asinh(z);
  const T z2 = (z * (2 * z * z + 1) * root - arsinh) / 8;    // integral of z^2 sqrt(1 + z^2)
  const T z4 = z * z * z * root * root * root / 6 - z2 / 2;  // integral of z^4 sqrt(1 + z^2)
  return about_center<T>(d * (z * root + arsinh) / 4, d * (root * root * root - 1) / 12, d * z2 / 8,
                         d * (z2 / 8 + z4 / 32));
}

/// The exercise's parameters: the parabola from 0 to q, its density, its center's initial velocity, and its
/// angular velocity.
template <class T>
struct Given {
  T q, d, u, v, w, g;
};

/// A wire thrown from the origin with velocity (u, v), rotating with w from the angle 0. The observable is
/// its mark, at b in the body.
template <class T>
struct Thrown {
  T mu0, mu2, u, v, w, g;
  Point<T> b;

  Point<T> mark(const T& x, const T& y, const T& theta) const {
    const T C = cos(theta), S = sin(theta);
    return {x + C * b[0] - S * b[1], y + S * b[0] + C * b[1]};
  }
};

/// The parabola, marked at its first end.
template <class T>
Thrown<T> thrown(const Given<T>& p) {
  const Inertia<T> i = inertia_of_parabola(p.q, p.d);
  return {i[0], i[3], p.u, p.v, p.w, p.g, {-i[1], -i[2]}};
}

/// The wire's center of mass alone.
template <class T>
struct PointMass {
  Thrown<T> p;
  Point<T> at(const T& t) const { return p.mark(p.u * t, p.v * t - p.g * t * t / 2, T(0)); }
  Pose<T> place(const T& t) const { return {p.u * t, p.v * t - p.g * t * t / 2, T(0)}; }
};

template <class T>
struct FreeFall {
  Thrown<T> p;
  Point<T> at(const T& t) const { return p.mark(p.u * t, p.v * t - p.g * t * t / 2, p.w * t); }
  Pose<T> place(const T& t) const { return {p.u * t, p.v * t - p.g * t * t / 2, p.w * t}; }
};

/// (x, y, theta, x', y', theta').
template <class T>
struct Generalized {
  Thrown<T> p;
  using State = std::array<T, 6>;
  State start() const { return {T(0), T(0), T(0), p.u, p.v, p.w}; }
  template <class X>
  void operator()(const std::array<X, 6>& x, std::array<X, 6>& dxdt, const X&) const {
    dxdt = {x[3], x[4], x[5], X(0), X(-p.g), X(0)};
  }
  template <class X>
  void acceleration(const std::array<X, 3>&, std::array<X, 3>& a) const {
    a = {X(0), X(-p.g), X(0)};
  }
  Point<T> observe(const State& x, const T&) const { return p.mark(x[0], x[1], x[2]); }
  Pose<T> place(const State& x, const T&) const { return {x[0], x[1], x[2]}; }
  auto conserved(const State& x, const T&) const {
    return energy_of<T>(p.mu0 * (x[3] * x[3] + x[4] * x[4]) / 2 + p.mu2 * x[5] * x[5] / 2,
                        p.mu0 * p.g * x[1]);
  }
};

/// Two particles of mu0/2 with the same moments, (x1, y1, x2, y2) and velocities. A massless rod keeps their
/// distance at 2 sqrt(mu2 / mu0): the second derivative of the constraint is zero.
template <class T>
struct TwoParticles {
  Thrown<T> p;
  using State = std::array<T, 8>;
  T k() const { return sqrt(p.mu2 / p.mu0); }
  State start() const { return {k(), T(0), -k(), T(0), p.u, p.v + p.w * k(), p.u, p.v - p.w * k()}; }
  template <class X>
  void operator()(const std::array<X, 8>& x, std::array<X, 8>& dxdt, const X&) const {
    const X dx = x[0] - x[2], dy = x[1] - x[3], du = x[4] - x[6], dv = x[5] - x[7];
    const X hold = (du * du + dv * dv) / (dx * dx + dy * dy) / 2;
    dxdt = {x[4], x[5], x[6], x[7], -hold * dx, -hold * dy - p.g, hold * dx, hold * dy - p.g};
  }
  Point<T> observe(const State& x, const T& t) const {
    const Pose<T> pose = place(x, t);
    return p.mark(pose[0], pose[1], pose[2]);
  }
  Pose<T> place(const State& x, const T&) const {
    return {(x[0] + x[2]) / 2, (x[1] + x[3]) / 2, atan2(x[1] - x[3], x[0] - x[2])};
  }
  auto conserved(const State& x, const T&) const {
    return energy_of<T>(p.mu0 / 4 * (x[4] * x[4] + x[5] * x[5] + x[6] * x[6] + x[7] * x[7]),
                        p.mu0 * p.g * (x[1] + x[3]) / 2);
  }
  std::array<T, 1> constraints(const State& x, const T&) const {
    return {hypot(x[0] - x[2], x[1] - x[3]) - 2 * k()};
  }
};

/// From the simplest to the richest.
template <class T>
auto models(const Given<T>& p) {
  const Thrown<T> wire = thrown(p);
  return std::tuple{PointMass<T>{wire}, FreeFall<T>{wire}, Generalized<T>{wire}, TwoParticles<T>{wire}};
}

}  // namespace oddity::planar_wire
