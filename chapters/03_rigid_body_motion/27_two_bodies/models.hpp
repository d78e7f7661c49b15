#pragma once

// The models of exercise 3.27.

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "chapters/03_rigid_body_motion/03_kepler/models.hpp"
#include "chapters/numbers.hpp"
#include "solvers/solved.hpp"

namespace oddity::two_bodies {

struct Bodies {
  double G, m1, m2, r0, r0_dot, phi0, phi0_dot;

  std::vector<double> inputs() const { return {G, m1, m2, r0, r0_dot, phi0, phi0_dot}; }
  /// The second body seen from the first: one body about a fixed sun of the mass of both.
  kepler::Start relative() const { return {G, m1 + m2, r0, r0_dot, phi0, phi0_dot}; }
};

/// (r, u, phi), as published. What is conserved is the energy per reduced mass; beta cannot drift.
struct Published : Bodies {
  using State = std::array<double, 3>;
  State start() const { return {r0, r0_dot, phi0}; }
  double beta() const { return r0 * r0 * phi0_dot; }
  double gamma() const { return G * (m1 + m2); }
  void operator()(const State& x, State& dxdt, double) const {
    const double r2 = x[0] * x[0];
    dxdt = {x[1], beta() * beta() / (r2 * x[0]) - gamma() / r2, beta() / r2};
  }
  std::array<double, 2> observe(const State& x, double) const {
    return {x[0] * std::cos(x[2]), x[0] * std::sin(x[2])};
  }
  auto conserved(const State& x, double) const {
    return energy_of(x[1] * x[1] / 2 + beta() * beta() / (2 * x[0] * x[0]), -gamma() / x[0]);
  }
};

/// (x1, y1, x2, y2 and their rates), the centre of mass at rest in the origin.
struct BothBodies : Bodies {
  using State = std::array<double, 8>;
  using Half = std::array<double, 4>;
  State start() const {
    const auto p = relative().position(), v = relative().velocity();
    const double a = -m2 / (m1 + m2), b = m1 / (m1 + m2);
    return {a * p[0], a * p[1], b * p[0], b * p[1], a * v[0], a * v[1], b * v[0], b * v[1]};
  }
  void acceleration(const Half& q, Half& a) const {
    const double dx = q[2] - q[0], dy = q[3] - q[1], square = dx * dx + dy * dy;
    const double pull = G / (square * std::sqrt(square));
    a = {m2 * pull * dx, m2 * pull * dy, -m1 * pull * dx, -m1 * pull * dy};
  }
  void operator()(const State& x, State& dxdt, double) const {
    Half a{};
    acceleration({x[0], x[1], x[2], x[3]}, a);
    dxdt = {x[4], x[5], x[6], x[7], a[0], a[1], a[2], a[3]};
  }
  std::array<double, 2> observe(const State& x, double) const { return {x[2] - x[0], x[3] - x[1]}; }
  /// The energy and the angular momentum about the centre of mass.
  std::array<Conserved<double>, 2> conserved(const State& x, double) const {
    const double kinetic = (m1 * (x[4] * x[4] + x[5] * x[5]) + m2 * (x[6] * x[6] + x[7] * x[7])) / 2;
    const double turning = m1 * (x[0] * x[5] - x[1] * x[4]) + m2 * (x[2] * x[7] - x[3] * x[6]);
    const double most = m1 * std::hypot(x[0], x[1]) * std::hypot(x[4], x[5]) +
                        m2 * std::hypot(x[2], x[3]) * std::hypot(x[6], x[7]);
    return {{{kinetic - G * m1 * m2 / std::hypot(x[2] - x[0], x[3] - x[1]), kinetic}, {turning, most}}};
  }
};

/// The relative position by Kepler's equation, solved by Newton's method from pi.
struct ByKeplersEquation : kepler::Ellipse {
  explicit ByKeplersEquation(const kepler::Start& relative) : Ellipse(relative) {}
  Solved<std::array<double, 2>> solved_at(double t) const {
    const double M = mean_anomaly(t);
    const Solved<double> E = kepler::newton(e, std::abs(M), std::numbers::pi, 50);
    Solved<std::array<double, 2>> place{at_eccentric_anomaly(std::copysign(E.value, M)), E.evaluations};
    place.ending = E.ending;
    place.message = E.message;
    return place;
  }
  std::array<double, 2> at(double t) const { return solved_at(t).value; }
};

}  // namespace oddity::two_bodies
