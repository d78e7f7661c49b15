#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "chapters/numbers.hpp"
#include "solvers/solved.hpp"

/// One body about a fixed sun: the start, the orbit by Kepler's equation, and the models that exercise 3.3
/// integrates. Position (r, theta), GM = mu, h = r^2 theta' (a constant), V = -GM/r.
namespace oddity::kepler {

struct Start {
  double G, M, r0, r0_dot, theta0, theta0_dot;

  double mu() const { return G * M; }
  double h() const { return r0 * r0 * theta0_dot; }
  /// Per unit mass of the planet; the orbit is an ellipse where it is negative.
  double energy() const { return (r0_dot * r0_dot + r0 * r0 * theta0_dot * theta0_dot) / 2 - mu() / r0; }
  std::array<double, 2> position() const { return {r0 * std::cos(theta0), r0 * std::sin(theta0)}; }
  std::array<double, 2> velocity() const {
    const double c = std::cos(theta0), s = std::sin(theta0), transverse = r0 * theta0_dot;
    return {r0_dot * c - transverse * s, r0_dot * s + transverse * c};
  }
};

/// Newton's method from E0; `stalled` when the last correction is not small after so many iterations.
inline Solved<double> newton(double e, double M, double E0, int iterations) {
  Solved<double> E{E0};
  for (int i = 0; i < iterations; ++i) {
    const double correction = (E.value - e * std::sin(E.value) - M) / (1 - e * std::cos(E.value));
    E.value -= correction;
    ++E.evaluations;
    if (std::abs(correction) <= 1e-15 * std::max(1.0, std::abs(E.value))) return E;
  }
  E.ending = Ending::stalled;
  E.message = "Newton's method has not settled";
  return E;
}

/// The elements of an elliptic orbit, from its start. Throws for any other orbit.
struct Ellipse {
  double a, e, n, M0, perihelion, turn;  ///< turn: the sense of rotation, +1 or -1

  explicit Ellipse(const Start& s) : a(-s.mu() / (2 * s.energy())) {
    if (!(s.energy() < 0)) throw std::domain_error("the orbit is no ellipse: the start is too fast");
    const double e_cos = 1 - s.r0 / a, e_sin = s.r0 * s.r0_dot / std::sqrt(s.mu() * a);
    const double E0 = std::atan2(e_sin, e_cos), b_over_a = s.h() / std::sqrt(s.mu() * a);
    e = std::hypot(e_cos, e_sin);
    n = std::sqrt(s.mu() / a) / a;
    M0 = E0 - e_sin;
    turn = b_over_a < 0 ? -1 : 1;
    minor = std::abs(b_over_a) * a;
    perihelion = s.theta0 - turn * std::atan2(minor * std::sin(E0), a * (std::cos(E0) - e));
  }

  /// The mean anomaly at t, between -pi and pi.
  double mean_anomaly(double t) const { return std::remainder(M0 + n * t, 2 * std::numbers::pi); }
  std::array<double, 2> at_eccentric_anomaly(double E) const {
    const double along = a * (std::cos(E) - e), across = turn * minor * std::sin(E);
    const double c = std::cos(perihelion), s = std::sin(perihelion);
    return {along * c - across * s, along * s + across * c};
  }

 private:
  double minor;
};

/// The position at t by Kepler's equation, solved by Newton's method from Danby's start.
struct ByKeplersEquation : Ellipse {
  explicit ByKeplersEquation(const Start& start) : Ellipse(start) {}
  std::array<double, 2> at(double t) const {
    const double M = mean_anomaly(t);
    const Solved<double> E = newton(e, M, M + std::copysign(0.85 * e, M), 20);
    return at_eccentric_anomaly(E.reached() ? E.value : std::numeric_limits<double>::quiet_NaN());
  }
};

// ---- models -----------------------------------------------------------------------------------------------

/// (x, y, x', y').
struct Cartesian : Start {
  using State = std::array<double, 4>;
  State start() const { return {position()[0], position()[1], velocity()[0], velocity()[1]}; }
  void acceleration(const std::array<double, 2>& q, std::array<double, 2>& a) const {
    const double square = q[0] * q[0] + q[1] * q[1], pull = -mu() / (square * std::sqrt(square));
    a = {pull * q[0], pull * q[1]};
  }
  void operator()(const State& x, State& dxdt, double) const {
    std::array<double, 2> a{};
    acceleration({x[0], x[1]}, a);
    dxdt = {x[2], x[3], a[0], a[1]};
  }
  std::array<double, 2> observe(const State& x, double) const { return {x[0], x[1]}; }
  /// The energy and the angular momentum, of which at most distance times speed could move.
  std::array<Conserved<double>, 2> conserved(const State& x, double) const {
    const double r = std::hypot(x[0], x[1]), square = x[2] * x[2] + x[3] * x[3];
    return {{{square / 2 - mu() / r, square / 2}, {x[0] * x[3] - x[1] * x[2], r * std::sqrt(square)}}};
  }
};

/// (r, theta, r', theta'): Item 1's two equations.
struct Polar : Start {
  using State = std::array<double, 4>;
  State start() const { return {r0, theta0, r0_dot, theta0_dot}; }
  void operator()(const State& x, State& dxdt, double) const {
    dxdt = {x[2], x[3], x[0] * x[3] * x[3] - mu() / (x[0] * x[0]), -2 * x[2] * x[3] / x[0]};
  }
  std::array<double, 2> observe(const State& x, double) const {
    return {x[0] * std::cos(x[1]), x[0] * std::sin(x[1])};
  }
  std::array<Conserved<double>, 2> conserved(const State& x, double) const {
    const double square = x[2] * x[2] + x[0] * x[0] * x[3] * x[3];
    return {
        {{square / 2 - mu() / x[0], square / 2}, {x[0] * x[0] * x[3], std::abs(x[0]) * std::sqrt(square)}}};
  }
};

/// (r, r', theta): equation (2) for the distance, equation (1) for the angle.
struct Distance : Start {
  using State = std::array<double, 3>;
  State start() const { return {r0, r0_dot, theta0}; }
  void operator()(const State& x, State& dxdt, double) const {
    const double rate = h() / (x[0] * x[0]);
    dxdt = {x[1], x[0] * rate * rate - mu() / (x[0] * x[0]), rate};
  }
  std::array<double, 2> observe(const State& x, double) const {
    return {x[0] * std::cos(x[2]), x[0] * std::sin(x[2])};
  }
  auto conserved(const State& x, double) const {
    return energy_of(x[1] * x[1] / 2 + h() * h() / (2 * x[0] * x[0]), -mu() / x[0]);
  }
};

/// (theta): equation (7), and V from equation (3). `V0` is the potential at the start that c0 and c1 take.
/// On an ellipse V never changes its sign; at the aphelion it is (1 - e) times its mean, so that r loses as
/// much.
struct OneAngle : Start {
  double alpha, mean, c0, c1;

  OneAngle(const Start& s, double V0) : Start(s), alpha(s.M * s.h()) {
    const double V0_prime = G * M * M * r0_dot / alpha, sine = std::sin(theta0), cosine = std::cos(theta0);
    mean = std::pow(G * M * M / alpha, 2);
    c0 = (V0 + mean) * sine + V0_prime * cosine;
    c1 = (V0 + mean) * cosine - V0_prime * sine;
  }
  using State = std::array<double, 1>;
  State start() const { return {theta0}; }
  double V(double theta) const { return c0 * std::sin(theta) + c1 * std::cos(theta) - mean; }
  void operator()(const State& x, State& dxdt, double) const {
    const double v = V(x[0]);
    dxdt = {alpha / (G * G * M * M * M) * v * v};
  }
  std::array<double, 2> observe(const State& x, double) const {
    const double r = -mu() / V(x[0]);
    return {r * std::cos(x[0]), r * std::sin(x[0])};
  }
};

/// Equation (7) with (4) and (5) as printed, V0 = +GM/r0; r from the polar equation, perihelion at theta = 0.
struct OneAngleAsPrinted : OneAngle {
  explicit OneAngleAsPrinted(const Start& s) : OneAngle(s, s.mu() / s.r0) {}
  std::array<double, 2> observe(const State& x, double) const {
    const double gamma0 = r0 * r0 * std::abs(theta0_dot);
    const double gamma1 =
        std::hypot(r0 * r0 * r0 * theta0_dot * theta0_dot - mu(), r0 * r0 * r0_dot * theta0_dot);
    const double e = gamma1 / mu(), rho = gamma0 * gamma0 / gamma1;
    const double r = e * rho / (1 + e * std::cos(x[0]));
    return {r * std::cos(x[0]), r * std::sin(x[0])};
  }
};

}  // namespace oddity::kepler
