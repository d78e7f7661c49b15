#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>

#include "chapters/numbers.hpp"

/// The models of exercise 3.7: a bead on the frictionless curve (q, q^2, q^3) under gravity along -z,
/// released at rest at q0. The observables are the position.
namespace oddity::bead_on_cubic {

template <class T>
std::array<T, 3> curve(const T& q) {
  return {q, q * q, q * q * q};
}

/// |dx/dq|^2.
template <class T>
T metric(const T& q) {
  return 1 + 4 * q * q + 9 * q * q * q * q;
}

/// The exercise's parameters.
template <class T>
struct Given {
  T q0, g;
};

/// Constant acceleration along the tangent at the start.
template <class T>
struct StraightTangent {
  Given<T> p;
  std::array<T, 3> at(const T& t) const {
    const T& q0 = p.q0;
    const T s = T(-1.5) * p.g * q0 * q0 / metric(q0) * t * t;
    return {q0 + s, q0 * q0 + 2 * q0 * s, q0 * q0 * q0 + 3 * q0 * q0 * s};
  }
};

/// q alone, with its speed from the energy.
template <class T>
struct EnergyInQ {
  Given<T> p;
  using State = std::array<T, 1>;
  static constexpr std::string_view not_analytic = "at rest the speed is the root of zero";
  State start() const { return {p.q0}; }
  template <class X>
  X speed(const X& q) const {
    const X fall = 2 * p.g * (p.q0 * p.q0 * p.q0 - q * q * q) / metric(q);
    return select(abs(fall) > X(0), sqrt(fall), X(0));
  }
  template <class X>
  void operator()(const std::array<X, 1>& x, std::array<X, 1>& dxdt, const X&) const {
    dxdt = {-speed(x[0])};
  }
  std::array<T, 3> observe(const State& x, const T&) const { return curve(x[0]); }
};

/// u alone, with q = q0 (1 - u^2): the same energy, regular at the initial condition.
template <class T>
struct EnergyInU {
  Given<T> p;
  using State = std::array<T, 1>;
  State start() const { return {T(0)}; }
  template <class X>
  X coordinate(const X& u) const {
    return p.q0 * (1 - u) * (1 + u);
  }
  template <class X>
  X seconds_per_u(const X& u) const {
    const X q = coordinate(u);
    return 2 * sqrt(p.q0 * metric(q) / (2 * p.g * (p.q0 * p.q0 + p.q0 * q + q * q)));
  }
  template <class X>
  void operator()(const std::array<X, 1>& x, std::array<X, 1>& dxdt, const X&) const {
    dxdt = {1 / seconds_per_u(x[0])};
  }
  std::array<T, 3> observe(const State& x, const T&) const { return curve(coordinate(x[0])); }
};

/// (q, q').
template <class T>
struct OneCoordinate {
  Given<T> p;
  using State = std::array<T, 2>;
  State start() const { return {p.q0, T(0)}; }
  template <class X>
  void operator()(const std::array<X, 2>& x, std::array<X, 2>& dxdt, const X&) const {
    const auto& [q, v] = x;
    dxdt = {v, -(3 * p.g * q * q + 2 * q * (2 + 9 * q * q) * v * v) / metric(q)};
  }
  std::array<T, 3> observe(const State& x, const T&) const { return curve(x[0]); }
  auto conserved(const State& x, const T&) const {
    return energy_of<T>(metric(x[0]) * x[1] * x[1] / 2, p.g * x[0] * x[0] * x[0]);
  }
};

/// (x, y, z, x', y', z'). The wire's force m1 (-2x, 1, 0) + m2 (-3x^2, 0, 1) keeps the second derivatives of
/// y - x^2 and z - x^3 zero.
template <class T>
struct CartesianWithConstraints {
  Given<T> p;
  using State = std::array<T, 6>;
  State start() const { return {p.q0, p.q0 * p.q0, p.q0 * p.q0 * p.q0, T(0), T(0), T(0)}; }
  template <class X>
  void operator()(const std::array<X, 6>& s, std::array<X, 6>& dsdt, const X&) const {
    const X x = s[0], j1 = 2 * x, j2 = 3 * x * x;
    const X b1 = 2 * s[3] * s[3], b2 = 6 * x * s[3] * s[3] + p.g;
    const X determinant = 1 + j1 * j1 + j2 * j2;
    const X m1 = ((1 + j2 * j2) * b1 - j1 * j2 * b2) / determinant;
    const X m2 = ((1 + j1 * j1) * b2 - j1 * j2 * b1) / determinant;
    dsdt = {s[3], s[4], s[5], -j1 * m1 - j2 * m2, m1, m2 - p.g};
  }
  std::array<T, 3> observe(const State& s, const T&) const { return {s[0], s[1], s[2]}; }
  auto conserved(const State& s, const T&) const {
    return energy_of<T>((s[3] * s[3] + s[4] * s[4] + s[5] * s[5]) / 2, p.g * s[2]);
  }
  /// From the wire's point with the same x; the wire itself may be nearer.
  std::array<T, 2> constraints(const State& s, const T&) const {
    const auto wire = curve(s[0]);
    return {s[1] - wire[1], s[2] - wire[2]};
  }
};

/// A model whose motion ends at the origin.
template <class Model>
struct ToTheOrigin : Model {
  using typename Model::State;
  template <class T>
  auto guards(const State& x, const T& t) const {
    return std::array{this->observe(x, t)[0]};
  }
  template <class T>
  Happening<State> at_event(std::size_t, const State& x, const T&) const {
    return {x, true};
  }
};

/// From the simplest to the richest.
template <class T>
auto models(const Given<T>& p) {
  return std::tuple{StraightTangent<T>{p},
                    EnergyInQ<T>{p},
                    EnergyInU<T>{p},
                    OneCoordinate<T>{p},
                    CartesianWithConstraints<T>{p},
                    ToTheOrigin<CartesianWithConstraints<T>>{{p}}};
}

}  // namespace oddity::bead_on_cubic
