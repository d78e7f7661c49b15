#pragma once

#include <array>
#include <cmath>

#include "chapters/numbers.hpp"

/// A bead on the frictionless curve (q, q^2, q^3) under gravity along -z, let go at rest at q0: its models,
/// whose observables are the position.
namespace oddity::bead_on_cubic {

template <class T>
std::array<T, 3> curve(const T& q) {
  return {q, q * q, q * q * q};
}

/// |dx/dq|^2.
inline double metric(double q) { return 1 + 4 * q * q + 9 * q * q * q * q; }

struct Bead {
  double q0, g;
};

/// Constant acceleration along the tangent at the start.
struct StraightTangent : Bead {
  std::array<double, 3> at(double t) const {
    const double s = -1.5 * g * q0 * q0 / metric(q0) * t * t;
    return {q0 + s, q0 * q0 + 2 * q0 * s, q0 * q0 * q0 + 3 * q0 * q0 * s};
  }
};

/// (q, q').
struct OneCoordinate : Bead {
  using State = std::array<double, 2>;
  State start() const { return {q0, 0}; }
  double acceleration(double q, double v) const {
    return -(3 * g * q * q + 2 * q * (2 + 9 * q * q) * v * v) / metric(q);
  }
  void operator()(const State& x, State& dxdt, double) const { dxdt = {x[1], acceleration(x[0], x[1])}; }
  std::array<double, 3> observe(const State& x, double) const { return curve(x[0]); }
  auto conserved(const State& x, double) const {
    return energy_of(metric(x[0]) * x[1] * x[1] / 2, g * x[0] * x[0] * x[0]);
  }
};

/// (x, y, z, x', y', z'); the wire's force m1 (-2x, 1, 0) + m2 (-3x^2, 0, 1) keeps y - x^2 and z - x^3
/// without acceleration.
struct CartesianWithConstraints : Bead {
  using State = std::array<double, 6>;
  State start() const { return {q0, q0 * q0, q0 * q0 * q0, 0, 0, 0}; }
  void operator()(const State& s, State& dsdt, double) const {
    const double x = s[0], j1 = 2 * x, j2 = 3 * x * x;
    const double b1 = 2 * s[3] * s[3], b2 = 6 * x * s[3] * s[3] + g;
    const double determinant = 1 + j1 * j1 + j2 * j2;
    const double m1 = ((1 + j2 * j2) * b1 - j1 * j2 * b2) / determinant;
    const double m2 = ((1 + j1 * j1) * b2 - j1 * j2 * b1) / determinant;
    dsdt = {s[3], s[4], s[5], -j1 * m1 - j2 * m2, m1, m2 - g};
  }
  std::array<double, 3> observe(const State& s, double) const { return {s[0], s[1], s[2]}; }
  auto conserved(const State& s, double) const {
    return energy_of((s[3] * s[3] + s[4] * s[4] + s[5] * s[5]) / 2, g * s[2]);
  }
  /// From the wire's point of the same x: the wire itself may be nearer.
  double off_constraint(const State& s, double) const {
    const auto wire = curve(s[0]);
    return std::hypot(s[1] - wire[1], s[2] - wire[2]);
  }
};

/// q alone, its speed from the energy.
struct EnergyInQ : Bead {
  using State = std::array<double, 1>;
  State start() const { return {q0}; }
  double speed(double q) const { return std::sqrt(2 * g * (q0 * q0 * q0 - q * q * q) / metric(q)); }
  void operator()(const State& x, State& dxdt, double) const { dxdt = {-speed(x[0])}; }
  std::array<double, 3> observe(const State& x, double) const { return curve(x[0]); }
};

/// u alone, q = q0 (1 - u^2): the same energy, regular at the start.
struct EnergyInU : Bead {
  using State = std::array<double, 1>;
  State start() const { return {0}; }
  double coordinate(double u) const { return q0 * (1 - u) * (1 + u); }
  double seconds_per_u(double u) const {
    const double q = coordinate(u);
    return 2 * std::sqrt(q0 * metric(q) / (2 * g * (q0 * q0 + q0 * q + q * q)));
  }
  void operator()(const State& x, State& dxdt, double) const { dxdt = {1 / seconds_per_u(x[0])}; }
  std::array<double, 3> observe(const State& x, double) const { return curve(coordinate(x[0])); }
};

}  // namespace oddity::bead_on_cubic
