#pragma once

#include <array>
#include <numbers>
#include <tuple>

#include "chapters/numbers.hpp"

/// One body about a fixed sun: the initial condition, the orbit by Kepler's equation, and the models that
/// exercise 3.3 integrates. Position (r, theta), GM = mu, h = r^2 theta' (a constant), V = -GM/r.
namespace oddity::kepler {

/// The exercise's parameters, and quantities that follow from them.
template <class T>
struct Given {
  T G, M, r0, r0_dot, theta0, theta0_dot;

  T mu() const { return G * M; }
  T h() const { return r0 * r0 * theta0_dot; }
  /// Per unit mass of the planet; negative for an ellipse.
  T energy() const { return (r0_dot * r0_dot + r0 * r0 * theta0_dot * theta0_dot) / 2 - mu() / r0; }
  std::array<T, 2> position() const { return {r0 * cos(theta0), r0 * sin(theta0)}; }
  std::array<T, 2> velocity() const {
    const T c = cos(theta0), s = sin(theta0), transverse = r0 * theta0_dot;
    return {r0_dot * c - transverse * s, r0_dot * s + transverse * c};
  }
};

/// State of Newton's method.
template <class T>
struct Iterate {
  T E;
  int corrections;
  bool settled;  ///< the last correction was small
};

/// Newton's method for E - e sin E = M from E0, with at most `most` corrections.
template <class T>
Iterate<T> newton(const T& e, const T& M, const T& E0, int most) {
  Iterate<T> now{E0, 0, false};
  T moving(1);  // each of several numbers stops moving when it has settled
  while (!now.settled && now.corrections < most) {
    const T slope = 1 - e * cos(now.E), correction = (now.E - e * sin(now.E) - M) / slope;
    now.E -= select(moving > T(0), correction, T(0));
    ++now.corrections;
    const T size = abs(now.E), roundings = (size + abs(M)) / slope, enough = select(size > T(1), size, T(1));
    moving = select(abs(correction) > T(unit_roundoff<T>) * (9 * enough + 2 * roundings), moving, T(0));
    now.settled = !any_of(moving > T(0));
  }
  return now;
}

/// The elements of an elliptic orbit from its initial condition; NaN for any other orbit.
template <class T>
struct Ellipse {
  T a, e, n, M0, perihelion, turn;  ///< turn: the sense of rotation, +1 or -1

  explicit Ellipse(const Given<T>& p) : a(-p.mu() / (2 * p.energy())) {
    const T e_cos = 1 - p.r0 / a, e_sin = p.r0 * p.r0_dot / sqrt(p.mu() * a);
    const T E0 = atan2(e_sin, e_cos), b_over_a = p.h() / sqrt(p.mu() * a);
    e = hypot(e_cos, e_sin);
    n = sqrt(p.mu() / a) / a;
    M0 = E0 - e_sin;
    turn = select(b_over_a < T(0), T(-1), T(1));
    minor = abs(b_over_a) * a;
    perihelion = p.theta0 - turn * atan2(minor * sin(E0), a * (cos(E0) - e));
  }

  /// The mean anomaly at t, between -pi and pi.
  T mean_anomaly(const T& t) const { return remainder(M0 + n * t, T(2 * std::numbers::pi)); }
  std::array<T, 2> at_eccentric_anomaly(const T& E) const {
    const T along = a * (cos(E) - e), across = turn * minor * sin(E);
    const T c = cos(perihelion), s = sin(perihelion);
    return {along * c - across * s, along * s + across * c};
  }

 private:
  T minor;
};

/// The position at t by Kepler's equation, solved by Newton's method from Danby's initial value.
template <class T>
struct ByKeplersEquation : Ellipse<T> {
  explicit ByKeplersEquation(const Given<T>& p) : Ellipse<T>(p) {}
  std::array<T, 2> at(const T& t) const {
    const T M = this->mean_anomaly(t);
    return this->at_eccentric_anomaly(newton<T>(this->e, M, M + copysign(T(0.85) * this->e, M), 20).E);
  }
};

// ---- models -----------------------------------------------------------------------------------------------

/// (theta): equation (7), with V from equation (3). `V0` is the initial potential in c0 and c1. On an ellipse
/// V never changes its sign. At the aphelion it is (1 - e) times its mean, so r loses as many digits.
template <class T>
struct OneAngle {
  Given<T> p;
  T alpha, mean, c0, c1;

  explicit OneAngle(const Given<T>& start) : OneAngle(start, -start.mu() / start.r0) {}
  OneAngle(const Given<T>& start, const T& V0) : p(start), alpha(p.M * p.h()) {
    const T V0_prime = p.G * p.M * p.M * p.r0_dot / alpha, sine = sin(p.theta0), cosine = cos(p.theta0);
    const T root = p.G * p.M * p.M / alpha;
    mean = root * root;
    c0 = (V0 + mean) * sine + V0_prime * cosine;
    c1 = (V0 + mean) * cosine - V0_prime * sine;
  }
  using State = std::array<T, 1>;
  State start() const { return {p.theta0}; }
  template <class X>
  X V(const X& theta) const {
    return c0 * sin(theta) + c1 * cos(theta) - mean;
  }
  template <class X>
  void operator()(const std::array<X, 1>& x, std::array<X, 1>& dxdt, const X&) const {
    const X v = V(x[0]);
    dxdt = {alpha / (p.G * p.G * p.M * p.M * p.M) * v * v};
  }
  std::array<T, 2> observe(const State& x, const T&) const {
    const T r = -p.mu() / V(x[0]);
    return {r * cos(x[0]), r * sin(x[0])};
  }
};

/// Equation (7) with (4) and (5) as printed, V0 = +GM/r0; r from the polar equation with perihelion at theta
/// = 0.
template <class T>
struct OneAngleAsPrinted : OneAngle<T> {
  using MovesAs = OneAngle<T>;
  explicit OneAngleAsPrinted(const Given<T>& start) : OneAngle<T>(start, start.mu() / start.r0) {}
  std::array<T, 2> observe(const std::array<T, 1>& x, const T&) const {
    const auto& [G, M, r0, r0_dot, theta0, w0] = this->p;
    const T mu = G * M, gamma0 = r0 * r0 * abs(w0);
    const T gamma1 = hypot(r0 * r0 * r0 * w0 * w0 - mu, r0 * r0 * r0_dot * w0);
    const T e = gamma1 / mu, rho = gamma0 * gamma0 / gamma1;
    const T r = e * rho / (1 + e * cos(x[0]));
    return {r * cos(x[0]), r * sin(x[0])};
  }
};

/// (r, r', theta): equation (2) for the distance, equation (1) for the angle.
template <class T>
struct Distance {
  Given<T> p;
  using State = std::array<T, 3>;
  State start() const { return {p.r0, p.r0_dot, p.theta0}; }
  template <class X>
  void operator()(const std::array<X, 3>& x, std::array<X, 3>& dxdt, const X&) const {
    const X rate = p.h() / (x[0] * x[0]);
    dxdt = {x[1], x[0] * rate * rate - p.mu() / (x[0] * x[0]), rate};
  }
  std::array<T, 2> observe(const State& x, const T&) const { return {x[0] * cos(x[2]), x[0] * sin(x[2])}; }
  auto conserved(const State& x, const T&) const {
    return energy_of<T>(x[1] * x[1] / 2 + p.h() * p.h() / (2 * x[0] * x[0]), -p.mu() / x[0]);
  }
};

/// (r, theta, r', theta'): the two equations of Item 1.
template <class T>
struct Polar {
  Given<T> p;
  using State = std::array<T, 4>;
  State start() const { return {p.r0, p.theta0, p.r0_dot, p.theta0_dot}; }
  template <class X>
  void operator()(const std::array<X, 4>& x, std::array<X, 4>& dxdt, const X&) const {
    dxdt = {x[2], x[3], x[0] * x[3] * x[3] - p.mu() / (x[0] * x[0]), -2 * x[2] * x[3] / x[0]};
  }
  std::array<T, 2> observe(const State& x, const T&) const { return {x[0] * cos(x[1]), x[0] * sin(x[1])}; }
  std::array<Conserved<T>, 2> conserved(const State& x, const T&) const {
    const T square = x[2] * x[2] + x[0] * x[0] * x[3] * x[3];
    return {{{square / 2 - p.mu() / x[0], square / 2}, {x[0] * x[0] * x[3], abs(x[0]) * sqrt(square)}}};
  }
};

/// (x, y, x', y').
template <class T>
struct Cartesian {
  Given<T> p;
  using State = std::array<T, 4>;
  State start() const {
    const auto q = p.position(), v = p.velocity();
    return {q[0], q[1], v[0], v[1]};
  }
  template <class X>
  void acceleration(const std::array<X, 2>& q, std::array<X, 2>& a) const {
    const X square = q[0] * q[0] + q[1] * q[1], pull = -p.mu() / (square * sqrt(square));
    a = {pull * q[0], pull * q[1]};
  }
  template <class X>
  void operator()(const std::array<X, 4>& x, std::array<X, 4>& dxdt, const X&) const {
    std::array<X, 2> a{};
    acceleration<X>({x[0], x[1]}, a);
    dxdt = {x[2], x[3], a[0], a[1]};
  }
  std::array<T, 2> observe(const State& x, const T&) const { return {x[0], x[1]}; }
  /// The energy and the angular momentum, whose moving part is distance times speed.
  std::array<Conserved<T>, 2> conserved(const State& x, const T&) const {
    const T r = hypot(x[0], x[1]), square = x[2] * x[2] + x[3] * x[3];
    return {{{square / 2 - p.mu() / r, square / 2}, {x[0] * x[3] - x[1] * x[2], r * sqrt(square)}}};
  }
};

/// From the simplest to the richest.
template <class T>
auto models(const Given<T>& p) {
  return std::tuple{
      OneAngleAsPrinted<T>(p), ByKeplersEquation<T>(p), OneAngle<T>(p), Distance<T>{p}, Polar<T>{p},
      Cartesian<T>{p}};
}

}  // namespace oddity::kepler
