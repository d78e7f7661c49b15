#pragma once

#include <array>
#include <cstddef>
#include <tuple>

#include "chapters/numbers.hpp"

/// The models of exercise 3.33, the heavy symmetric top; 3.35 moves its tip. Euler angles: R = Rz(theta)
/// Rx(phi) Rz(psi) takes body to world coordinates; mu1, mu3 are the moments about the tip.
namespace oddity::heavy_top {

template <class T>
using Vector = std::array<T, 3>;

template <class T>
using Matrix = std::array<std::array<T, 3>, 3>;

template <class T>
Matrix<T> product(const Matrix<T>& a, const Matrix<T>& b) {
  Matrix<T> c;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  return c;
}

/// Rz(theta) Rx(phi) Rz(psi), expanded by a program; its last column is the top's axis.
template <class T>
Matrix<T> rotation(const T& theta, const T& phi, const T& psi) {
  const T zero(0), one(1);
  const auto about_z = [&](const T& a) {
    return Matrix<T>{{{cos(a), -sin(a), zero}, {sin(a), cos(a), zero}, {zero, zero, one}}};
  };
  const Matrix<T> about_x{{{one, zero, zero}, {zero, cos(phi), -sin(phi)}, {zero, sin(phi), cos(phi)}}};
  return product(product(about_z(theta), about_x), about_z(psi));
}

/// The axis for these angles.
template <class T>
Vector<T> axis_of(const T& theta, const T& phi) {
  return {sin(theta) * sin(phi), -cos(theta) * sin(phi), cos(phi)};
}

/// The exercise's parameters: a top, and its initial angles and rates.
template <class T>
struct Given {
  T m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi;

  T spin() const { return dpsi + dtheta * cos(phi); }  ///< c
  T a() const { return mu3 * spin() / mu1; }
  T b() const { return a() * cos(phi) + dtheta * sin(phi) * sin(phi); }  ///< gamma/mu1
  T alpha() const { return m * g * l / mu1; }

  Vector<T> axis() const { return axis_of(theta, phi); }
  /// The quaternion of the angles.
  std::array<T, 4> orientation() const {
    const T half = phi / 2, sum = (theta + psi) / 2, difference = (theta - psi) / 2;
    return {cos(half) * cos(sum), sin(half) * cos(difference), sin(half) * sin(difference),
            cos(half) * sin(sum)};
  }
  /// Angular velocity in body coordinates: phi' along the line of nodes, theta' along k, psi' along the axis.
  Vector<T> body_rates() const {
    const Matrix<T> r = rotation(theta, phi, psi);
    return {dphi * cos(psi) + dtheta * r[2][0], -dphi * sin(psi) + dtheta * r[2][1], dpsi + dtheta * r[2][2]};
  }
};

/// Rates that depend on the tilt alone; the constants of the motion are computed once.
template <class T>
struct ByTilt {
  T a, b, alpha;

  explicit ByTilt(const Given<T>& p) : a(p.a()), b(p.b()), alpha(p.alpha()) {}
  /// theta' and phi'' at a tilt.
  template <class X>
  std::array<X, 2> rates(const X& tilt) const {
    const X s = sin(tilt), c = cos(tilt), rate = (b - a * c) / (s * s);
    return {rate, s * (alpha + rate * (rate * c - a))};
  }
};

/// A top whose tip p is at (A sin(lambda t), 0, 0). Relative to the tip, the force at the center of mass is
/// -m g k - m p''.
template <class T>
struct Top : Given<T> {
  T A = T(0), lambda = T(0);

  template <class X>
  X tip_acceleration(const X& t) const {
    return -A * lambda * lambda * sin(lambda * t);
  }
  template <class X>
  Vector<X> force(const X& t) const {
    return {-this->m * tip_acceleration(t), X(0), X(-this->m * this->g)};
  }
};

/// The angular velocity in world coordinates of a top with this axis, angular momentum and spin.
template <class T>
Vector<T> turning_of(const Vector<T>& d, const Vector<T>& L, const T& spin, const T& mu1) {
  const T rest = spin - dot(L, d) / mu1;
  return {L[0] / mu1 + rest * d[0], L[1] / mu1 + rest * d[1], L[2] / mu1 + rest * d[2]};
}

// ---- each observes the axis, or its height ----------------------------------------------------------------

/// The tilt is constant, and the precession has the rate m g l/(mu3 c) of a fast top.
template <class T>
struct MeanPrecession {
  Given<T> p;
  Vector<T> at(const T& t) const {
    return axis_of<T>(p.theta + p.m * p.g * p.l / (p.mu3 * p.spin()) * t, p.phi);
  }
};

/// (phi, phi'): one degree of freedom in an effective potential. Observes the height of the axis.
template <class T>
struct Nutation {
  Given<T> p;
  ByTilt<T> by_tilt = ByTilt<T>(p);
  using State = std::array<T, 2>;
  State start() const { return {p.phi, p.dphi}; }
  template <class X>
  void operator()(const std::array<X, 2>& x, std::array<X, 2>& dxdt, const X&) const {
    dxdt = {x[1], by_tilt.rates(x[0])[1]};
  }
  template <class X>
  void acceleration(const std::array<X, 1>& q, std::array<X, 1>& dv) const {
    dv = {by_tilt.rates(q[0])[1]};
  }
  std::array<T, 1> observe(const State& x, const T&) const { return {cos(x[0])}; }
  auto conserved(const State& x, const T&) const {
    const T turning = by_tilt.rates(x[0])[0] * sin(x[0]);
    return energy_of<T>(x[1] * x[1] + turning * turning, 2 * by_tilt.alpha * cos(x[0]));
  }
};

/// (u, u'), u = cos(phi): u'' is a polynomial, and the vertical is not singular.
template <class T>
struct HeightAlone {
  Given<T> p;
  T a = p.a(), b = p.b(), alpha = p.alpha(), e = constant();
  using State = std::array<T, 2>;
  State start() const { return {cos(p.phi), -sin(p.phi) * p.dphi}; }
  T constant() const {
    const T turning = p.dtheta * sin(p.phi);
    return p.dphi * p.dphi + turning * turning + 2 * p.alpha() * cos(p.phi);
  }
  template <class X>
  void operator()(const std::array<X, 2>& x, std::array<X, 2>& dxdt, const X&) const {
    const X& u = x[0];
    dxdt = {x[1], -alpha * (1 - u * u) - (e - 2 * alpha * u) * u + a * (b - a * u)};
  }
  std::array<T, 1> observe(const State& x, const T&) const { return {x[0]}; }
};

/// (phi, phi', theta): the precession by quadrature.
template <class T>
struct OneAngle {
  Given<T> p;
  ByTilt<T> by_tilt = ByTilt<T>(p);
  using State = std::array<T, 3>;
  State start() const { return {p.phi, p.dphi, p.theta}; }
  template <class X>
  void operator()(const std::array<X, 3>& x, std::array<X, 3>& dxdt, const X&) const {
    const auto [turning, tilting] = by_tilt.rates(x[0]);
    dxdt = {x[1], tilting, turning};
  }
  Vector<T> observe(const State& x, const T&) const { return axis_of(x[2], x[0]); }
  /// The angular velocity in world coordinates; drawings turn the top by it.
  Vector<T> turning(const State& x, const T&) const {
    const T turning = by_tilt.rates(x[0])[0], own = p.spin() - turning * cos(x[0]);
    const Vector<T> d = axis_of(x[2], x[0]);
    return {x[1] * cos(x[2]) + own * d[0], x[1] * sin(x[2]) + own * d[1], turning + own * d[2]};
  }
  auto conserved(const State& x, const T& t) const { return Nutation<T>{p}.conserved({x[0], x[1]}, t); }
};

/// (theta, phi, psi, theta', phi', psi').
template <class T>
struct EulerAngles {
  Top<T> p;
  using State = std::array<T, 6>;
  State start() const { return {p.theta, p.phi, p.psi, p.dtheta, p.dphi, p.dpsi}; }
  template <class X>
  void operator()(const std::array<X, 6>& x, std::array<X, 6>& dxdt, const X& t) const {
    const X s = sin(x[1]), c = cos(x[1]), total = x[5] + x[3] * c;
    const Vector<X> f = p.force(t);
    const X turning =
        (p.l * f[0] * cos(x[0]) - 2 * p.mu1 * x[3] * x[4] * c + p.mu3 * total * x[4]) / (p.mu1 * s);
    const X tilting =
        (p.l * (f[0] * sin(x[0]) * c - f[2] * s) - p.mu3 * total * x[3] * s) / p.mu1 + x[3] * x[3] * s * c;
    dxdt = {x[3], x[4], x[5], turning, tilting, x[3] * x[4] * s - turning * c};
  }
  Vector<T> observe(const State& x, const T&) const { return axis_of(x[0], x[1]); }
  /// The spin momentum; for a fixed tip also the energy, whose moving part is that of the axis.
  std::array<Conserved<T>, 2> conserved(const State& x, const T&) const {
    const T s = sin(x[1]), c = cos(x[1]), total = x[5] + x[3] * c;
    const T across = p.mu1 * hypot(x[4], x[3] * s), spin = p.mu3 * total;
    const T kinetic = across * across / (2 * p.mu1);
    const auto moves = abs(p.A) > T(0);
    return {{{spin, hypot(spin, across)},
             {select(moves, T(0), T(kinetic + spin * total / 2 + p.m * p.g * p.l * c)),
              select(moves, T(0), kinetic)}}};
  }
};

/// (quaternion, angular velocity in body coordinates): Euler's equations with the torque about the tip.
template <class T>
struct RigidBody {
  Top<T> p;
  using State = std::array<T, 7>;
  static constexpr std::array<std::size_t, 3> velocities{4, 5, 6};
  State start() const {
    const auto [q, i, j, k] = p.orientation();
    const Vector<T> w = p.body_rates();
    return {q, i, j, k, w[0], w[1], w[2]};
  }
  template <class X>
  void operator()(const std::array<X, 7>& x, std::array<X, 7>& dxdt, const X& t) const {
    const auto& [q, i, j, k, w1, w2, w3] = x;
    const Vector<X> f = p.force(t);
    const X f1 = (1 - 2 * (j * j + k * k)) * f[0] + 2 * (i * k - q * j) * f[2];
    const X f2 = 2 * (i * j - q * k) * f[0] + 2 * (j * k + q * i) * f[2];
    dxdt = {(-i * w1 - j * w2 - k * w3) / 2,
            (q * w1 + j * w3 - k * w2) / 2,
            (q * w2 + k * w1 - i * w3) / 2,
            (q * w3 + i * w2 - j * w1) / 2,
            ((p.mu1 - p.mu3) * w2 * w3 - p.l * f2) / p.mu1,
            ((p.mu3 - p.mu1) * w3 * w1 + p.l * f1) / p.mu1,
            X(0)};
  }
  Vector<T> observe(const State& x, const T&) const {
    const T norm = square(x);
    return {2 * (x[1] * x[3] + x[0] * x[2]) / norm, 2 * (x[2] * x[3] - x[0] * x[1]) / norm,
            1 - 2 * (x[1] * x[1] + x[2] * x[2]) / norm};
  }
  /// The quaternion's square; for a fixed tip also the energy, whose moving part is that of the axis.
  std::array<Conserved<T>, 2> conserved(const State& x, const T& t) const {
    const T kinetic = p.mu1 * (x[4] * x[4] + x[5] * x[5]) / 2;
    const auto moves = abs(p.A) > T(0);
    return {{{square(x), T(1)},
             {select(moves, T(0), T(kinetic + p.mu3 * x[6] * x[6] / 2 + p.m * p.g * p.l * observe(x, t)[2])),
              select(moves, T(0), kinetic)}}};
  }

 private:
  static T square(const State& x) { return x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]; }
};

/// (axis, angular momentum about the tip): d' = L x d/mu1, L' = l d x F. The spin is L.d.
template <class T>
struct AxisAndMomentum {
  Top<T> p;
  using State = std::array<T, 6>;
  State start() const {
    const Vector<T> d = p.axis(), w = p.body_rates();
    const Matrix<T> r = rotation(p.theta, p.phi, p.psi);
    State x{d[0], d[1], d[2], T(0), T(0), T(0)};
    for (std::size_t i = 0; i < 3; ++i)
      x[3 + i] = p.mu1 * (r[i][0] * w[0] + r[i][1] * w[1]) + p.mu3 * r[i][2] * w[2];
    return x;
  }
  template <class X>
  void operator()(const std::array<X, 6>& x, std::array<X, 6>& dxdt, const X& t) const {
    const Vector<X> d{x[0], x[1], x[2]}, turn = cross(Vector<X>{x[3], x[4], x[5]}, d),
                                         torque = cross(d, p.force(t));
    dxdt = {turn[0] / p.mu1, turn[1] / p.mu1, turn[2] / p.mu1,
            p.l * torque[0], p.l * torque[1], p.l * torque[2]};
  }
  Vector<T> observe(const State& x, const T&) const { return {x[0], x[1], x[2]}; }
  Vector<T> turning(const State& x, const T&) const {
    return turning_of<T>({x[0], x[1], x[2]}, {x[3], x[4], x[5]}, p.spin(), p.mu1);
  }
  /// The spin momentum.
  std::array<Conserved<T>, 1> conserved(const State& x, const T&) const {
    return {{{x[0] * x[3] + x[1] * x[4] + x[2] * x[5], sqrt(x[3] * x[3] + x[4] * x[4] + x[5] * x[5])}}};
  }
  /// Deviation of the center of mass from the distance l to the tip.
  std::array<T, 1> constraints(const State& x, const T&) const {
    return {p.l * (sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]) - 1)};
  }
};

/// From the simplest to the richest.
template <class T>
auto models(const Given<T>& p) {
  return std::tuple{MeanPrecession<T>{p}, Nutation<T>{p},    HeightAlone<T>{p},      OneAngle<T>{p},
                    EulerAngles<T>{{p}},  RigidBody<T>{{p}}, AxisAndMomentum<T>{{p}}};
}

}  // namespace oddity::heavy_top
