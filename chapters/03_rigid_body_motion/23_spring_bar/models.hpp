#pragma once

// The models of exercise 3.23.

#include <array>
#include <cmath>

#include "chapters/numbers.hpp"

namespace oddity::spring_bar {

/// A bar without mass that turns about the origin, a mass m at the distance r, and at the distance s a spring
/// of constant c and rest length ell that stands on (s, -h). It starts at theta0 with angular speed w0.
struct Bar {
  double m, r, s, c, h, g, ell, theta0, w0;

  /// Twice differentiable in q by dual numbers; built from the positions alone.
  template <class Q>
  Q potential(const Q& q) const {
    using std::cos, std::sin, std::sqrt;
    const Q dx = s * cos(q) - s, dy = s * sin(q) + h;
    const Q stretch = sqrt(dx * dx + dy * dy) - ell;
    return m * g * r * sin(q) + 0.5 * c * stretch * stretch;
  }
  std::array<double, 2> position(double angle) const { return {r * std::cos(angle), r * std::sin(angle)}; }
  /// At theta = 0, where the spring is upright: V'' = c s^2 whatever h, ell and g are.
  double frequency() const { return s / r * std::sqrt(c / m); }
  /// The rest length for which theta = 0 is an equilibrium.
  double balancing_rest_length() const { return h + m * g * r / (c * s); }
};

/// The equation linearized about theta = 0.
struct SmallOscillation : Bar {
  std::array<double, 2> at(double t) const {
    const double w = frequency(), middle = -(m * g * r + c * s * (h - ell)) / (c * s * s);
    return position(middle + (theta0 - middle) * std::cos(w * t) + w0 / w * std::sin(w * t));
  }
};

/// (theta, theta').
struct OneAngle : Bar {
  using State = std::array<double, 2>;
  State start() const { return {theta0, w0}; }
  template <class Q>
  Q acceleration_at(const Q& q) const {
    using std::cos, std::sin, std::sqrt;
    const Q dx = s * cos(q) - s, dy = s * sin(q) + h;
    const Q pull = c * (1.0 - ell / sqrt(dx * dx + dy * dy));
    return -(m * g * r * cos(q) + pull * (dy * s * cos(q) - dx * s * sin(q))) / (m * r * r);
  }
  template <class X, class T>
  void operator()(const X& x, X& dxdt, const T&) const {
    dxdt = {x[1], acceleration_at(x[0])};
  }
  void acceleration(const std::array<double, 1>& q, std::array<double, 1>& a) const {
    a = {acceleration_at(q[0])};
  }
  std::array<double, 2> observe(const State& x, double) const { return position(x[0]); }
  auto conserved(const State& x, double) const {
    return energy_of(m * r * r * x[1] * x[1] / 2, potential(x[0]));
  }
};

/// (x, y, x', y') of the mass; the spring's force reaches it through the lever, s/r of it, and the bar holds
/// it by x^2 + y^2 = r^2, twice differentiated.
struct CartesianWithConstraint : Bar {
  using State = std::array<double, 4>;
  State start() const {
    return {r * std::cos(theta0), r * std::sin(theta0), -r * w0 * std::sin(theta0),
            r * w0 * std::cos(theta0)};
  }
  /// Force on the mass over m, without the bar's hold.
  std::array<double, 2> pushed(double x, double y) const {
    const double lever = s / r, dx = lever * x - s, dy = lever * y + h;
    const double pull = -lever * c / m * (1 - ell / std::hypot(dx, dy));
    return {pull * dx, pull * dy - g};
  }
  void operator()(const State& x, State& dxdt, double) const {
    const auto f = pushed(x[0], x[1]);
    const double hold = (x[2] * x[2] + x[3] * x[3] + f[0] * x[0] + f[1] * x[1]) / (x[0] * x[0] + x[1] * x[1]);
    dxdt = {x[2], x[3], f[0] - hold * x[0], f[1] - hold * x[1]};
  }
  std::array<double, 2> observe(const State& x, double) const { return {x[0], x[1]}; }
  auto conserved(const State& x, double) const {
    const double stretch = std::hypot(s / r * x[0] - s, s / r * x[1] + h) - ell;
    return energy_of(m * (x[2] * x[2] + x[3] * x[3]) / 2, m * g * x[1] + c * stretch * stretch / 2);
  }
  double off_constraint(const State& x, double) const { return std::abs(std::hypot(x[0], x[1]) - r); }
};

}  // namespace oddity::spring_bar
