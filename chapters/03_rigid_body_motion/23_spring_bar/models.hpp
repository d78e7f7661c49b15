#pragma once

#include <array>
#include <tuple>

#include "chapters/numbers.hpp"

/// The models of exercise 3.23: a massless bar that turns about the origin, with a mass m at the distance r.
/// A spring of constant c and rest length ell, based at (s, -h), acts on it at the distance s. The bar starts
/// at theta0 with angular speed w0.
namespace oddity::spring_bar {

template <class T>
struct Given {
  T m, r, s, c, h, g, ell, theta0, w0;

  /// From the positions alone.
  template <class X>
  X potential(const X& q) const {
    const X dx = s * cos(q) - s, dy = s * sin(q) + h;
    const X stretch = sqrt(dx * dx + dy * dy) - ell;
    return m * g * r * sin(q) + c / 2 * stretch * stretch;
  }
  std::array<T, 2> position(const T& angle) const { return {r * cos(angle), r * sin(angle)}; }
  /// At theta = 0, with the spring vertical: V'' = c s^2 for any h, ell and g.
  T frequency() const { return s / r * sqrt(c / m); }
  /// The rest length for which theta = 0 is an equilibrium.
  T balancing_rest_length() const { return h + m * g * r / (c * s); }
};

/// The equation linearized about theta = 0.
template <class T>
struct SmallOscillation {
  Given<T> p;
  std::array<T, 2> at(const T& t) const {
    const T w = p.frequency(), middle = -(p.m * p.g * p.r + p.c * p.s * (p.h - p.ell)) / (p.c * p.s * p.s);
    return p.position(middle + (p.theta0 - middle) * cos(w * t) + p.w0 / w * sin(w * t));
  }
};

/// (theta, theta').
template <class T>
struct OneAngle {
  Given<T> p;
  using State = std::array<T, 2>;
  State start() const { return {p.theta0, p.w0}; }
  template <class X>
  X acceleration_at(const X& q) const {
    const X dx = p.s * cos(q) - p.s, dy = p.s * sin(q) + p.h;
    const X pull = p.c * (1 - p.ell / sqrt(dx * dx + dy * dy));
    return -(p.m * p.g * p.r * cos(q) + pull * (dy * p.s * cos(q) - dx * p.s * sin(q))) / (p.m * p.r * p.r);
  }
  template <class X>
  void operator()(const std::array<X, 2>& x, std::array<X, 2>& dxdt, const X&) const {
    dxdt = {x[1], acceleration_at(x[0])};
  }
  template <class X>
  void acceleration(const std::array<X, 1>& q, std::array<X, 1>& dv) const {
    dv = {acceleration_at(q[0])};
  }
  std::array<T, 2> observe(const State& x, const T&) const { return p.position(x[0]); }
  auto conserved(const State& x, const T&) const {
    return energy_of<T>(p.m * p.r * p.r * x[1] * x[1] / 2, p.potential(x[0]));
  }
};

/// (x, y, x', y') of the mass. The lever passes s/r of the spring's force to it, and the bar keeps the second
/// derivative of x^2 + y^2 = r^2 zero.
template <class T>
struct CartesianWithConstraint {
  Given<T> p;
  using State = std::array<T, 4>;
  State start() const {
    const auto [x, y] = p.position(p.theta0);
    return {x, y, -p.r * p.w0 * sin(p.theta0), p.r * p.w0 * cos(p.theta0)};
  }
  /// Force on the mass per m, without the bar's constraint.
  template <class X>
  std::array<X, 2> pushed(const X& x, const X& y) const {
    const T lever = p.s / p.r;
    const X dx = lever * x - p.s, dy = lever * y + p.h;
    const X pull = -lever * p.c / p.m * (1 - p.ell / hypot(dx, dy));
    return {pull * dx, pull * dy - p.g};
  }
  template <class X>
  void operator()(const std::array<X, 4>& x, std::array<X, 4>& dxdt, const X&) const {
    const auto f = pushed(x[0], x[1]);
    const X hold = (x[2] * x[2] + x[3] * x[3] + f[0] * x[0] + f[1] * x[1]) / (x[0] * x[0] + x[1] * x[1]);
    dxdt = {x[2], x[3], f[0] - hold * x[0], f[1] - hold * x[1]};
  }
  std::array<T, 2> observe(const State& x, const T&) const { return {x[0], x[1]}; }
  auto conserved(const State& x, const T&) const {
    const T stretch = hypot(p.s / p.r * x[0] - p.s, p.s / p.r * x[1] + p.h) - p.ell;
    return energy_of<T>(p.m * (x[2] * x[2] + x[3] * x[3]) / 2,
                        p.m * p.g * x[1] + p.c * stretch * stretch / 2);
  }
  std::array<T, 1> constraints(const State& x, const T&) const { return {hypot(x[0], x[1]) - p.r}; }
};

/// From the simplest to the richest.
template <class T>
auto models(const Given<T>& p) {
  return std::tuple{SmallOscillation<T>{p}, OneAngle<T>{p}, CartesianWithConstraint<T>{p}};
}

}  // namespace oddity::spring_bar
