#pragma once

#include <array>
#include <cstddef>
#include <numbers>
#include <tuple>

#include "chapters/03_rigid_body_motion/03_kepler/models.hpp"
#include "chapters/numbers.hpp"

/// The models of exercise 3.27: two bodies that attract each other, with the second observed relative to the
/// first.
namespace oddity::two_bodies {

/// The exercise's parameters.
template <class T>
struct Given {
  T G, m1, m2, r0, r0_dot, phi0, phi0_dot;

  /// Relative motion: one body about a fixed sun of the total mass.
  kepler::Given<T> relative() const { return {G, m1 + m2, r0, r0_dot, phi0, phi0_dot}; }
};

/// The relative position by Kepler's equation, solved by Newton's method from pi.
template <class T>
struct ByKeplersEquation : kepler::Ellipse<T> {
  explicit ByKeplersEquation(const Given<T>& p) : kepler::Ellipse<T>(p.relative()) {}
  std::array<T, 2> at(const T& t) const {
    const T M = this->mean_anomaly(t);
    const auto found = kepler::newton<T>(this->e, abs(M), T(std::numbers::pi), 50);
    return this->at_eccentric_anomaly(copysign(found.E, M));
  }
};

/// (r, u, phi), as published. The conserved quantity is the energy per reduced mass; beta cannot drift.
template <class T>
struct Published {
  Given<T> p;
  using State = std::array<T, 3>;
  State start() const { return {p.r0, p.r0_dot, p.phi0}; }
  T beta() const { return p.r0 * p.r0 * p.phi0_dot; }
  T gamma() const { return p.G * (p.m1 + p.m2); }
  template <class X>
  void operator()(const std::array<X, 3>& x, std::array<X, 3>& dxdt, const X&) const {
    const X r2 = x[0] * x[0];
    dxdt = {x[1], beta() * beta() / (r2 * x[0]) - gamma() / r2, beta() / r2};
  }
  std::array<T, 2> observe(const State& x, const T&) const { return {x[0] * cos(x[2]), x[0] * sin(x[2])}; }
  auto conserved(const State& x, const T&) const {
    return energy_of<T>(x[1] * x[1] / 2 + beta() * beta() / (2 * x[0] * x[0]), -gamma() / x[0]);
  }
};

/// The published system, ending after one turn of phi.
template <class T>
struct OneTurn : Published<T> {
  using MovesAs = Published<T>;
  using typename Published<T>::State;
  std::array<T, 1> guards(const State& x, const T&) const {
    return {T(2 * std::numbers::pi) - (x[2] - this->p.phi0)};
  }
  Happening<State> at_event(std::size_t, const State& x, const T&) const { return {x, true}; }
};

/// (x1, y1, x2, y2 and their rates), with the centre of mass at rest at the origin.
template <class T>
struct BothBodies {
  Given<T> p;
  using State = std::array<T, 8>;
  State start() const {
    const auto q = p.relative().position(), v = p.relative().velocity();
    const T a = -p.m2 / (p.m1 + p.m2), b = p.m1 / (p.m1 + p.m2);
    return {a * q[0], a * q[1], b * q[0], b * q[1], a * v[0], a * v[1], b * v[0], b * v[1]};
  }
  template <class X>
  void acceleration(const std::array<X, 4>& q, std::array<X, 4>& a) const {
    const X dx = q[2] - q[0], dy = q[3] - q[1], square = dx * dx + dy * dy;
    const X pull = p.G / (square * sqrt(square));
    a = {p.m2 * pull * dx, p.m2 * pull * dy, -p.m1 * pull * dx, -p.m1 * pull * dy};
  }
  template <class X>
  void operator()(const std::array<X, 8>& x, std::array<X, 8>& dxdt, const X&) const {
    std::array<X, 4> a{};
    acceleration<X>({x[0], x[1], x[2], x[3]}, a);
    dxdt = {x[4], x[5], x[6], x[7], a[0], a[1], a[2], a[3]};
  }
  std::array<T, 2> observe(const State& x, const T&) const { return {x[2] - x[0], x[3] - x[1]}; }
  /// The energy and the angular momentum about the centre of mass.
  std::array<Conserved<T>, 2> conserved(const State& x, const T&) const {
    const auto& [G, m1, m2, r0, r0_dot, phi0, phi0_dot] = p;
    const T kinetic = (m1 * (x[4] * x[4] + x[5] * x[5]) + m2 * (x[6] * x[6] + x[7] * x[7])) / 2;
    const T turning = m1 * (x[0] * x[5] - x[1] * x[4]) + m2 * (x[2] * x[7] - x[3] * x[6]);
    const T most = m1 * hypot(x[0], x[1]) * hypot(x[4], x[5]) + m2 * hypot(x[2], x[3]) * hypot(x[6], x[7]);
    return {{{kinetic - G * m1 * m2 / hypot(x[2] - x[0], x[3] - x[1]), kinetic}, {turning, most}}};
  }
};

/// From the simplest to the richest.
template <class T>
auto models(const Given<T>& p) {
  return std::tuple{ByKeplersEquation<T>(p), Published<T>{p}, OneTurn<T>{{p}}, BothBodies<T>{p}};
}

}  // namespace oddity::two_bodies
