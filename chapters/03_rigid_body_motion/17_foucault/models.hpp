#pragma once

// The models of exercise 3.17. Axes x to the west, y to the north, z down; w = omega (0, cos lambda, -sin
// lambda).

#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include "chapters/03_rigid_body_motion/shared/pair.hpp"
#include "chapters/numbers.hpp"

namespace oddity::foucault {

// ---- vectors generic in their number type -----------------------------------------------------------------

template <class T>
using Space = std::array<T, 3>;

template <class T>
T inner(const Space<T>& a, const Space<T>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
template <class T>
Space<T> outer(const Space<T>& a, const Space<T>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// ---- the pendulum -----------------------------------------------------------------------------------------

/// Angle theta about the vertical, from west to north; phi from the lower vertical.
template <class T>
struct Axes {
  Space<T> P, Q, R;
  explicit Axes(const Two<T>& q) {
    using std::cos, std::sin;
    const T c = cos(q[0]), s = sin(q[0]), cp = cos(q[1]), sp = sin(q[1]);
    P = {-s, c, T(0.0)};
    Q = {-c * cp, -s * cp, sp};
    R = {c * sp, s * sp, cp};
  }
};

struct Pendulum {
  double lambda, L, omega, g, theta, phi, theta_dot, phi_dot;

  std::vector<double> inputs() const { return {lambda, L, omega, g, theta, phi, theta_dot, phi_dot}; }
  Space<double> w() const { return {0, omega * std::cos(lambda), -omega * std::sin(lambda)}; }
  std::array<double, 6> cartesian() const {
    const double c = std::cos(theta), s = std::sin(theta), cp = std::cos(phi), sp = std::sin(phi);
    return {L * (c * sp),
            L * (s * sp),
            L * cp,
            L * (-s * theta_dot * sp + c * (cp * phi_dot)),
            L * (c * theta_dot * sp + s * (cp * phi_dot)),
            L * (-sp * phi_dot)};
  }
};

// ---- closed forms -----------------------------------------------------------------------------------------

/// z'' = 2i W z' - (g/L) z for z = x + iy, W = omega sin lambda: exp(iWt)(A cos nt + B sin nt), n^2 = g/L +
/// W^2; averaged: n^2 = g/L, the free ellipse in axes that turn with W.
struct SmallAngle : Pendulum {
  bool averaged = false;
  double turning() const { return omega * std::sin(lambda); }
  Pair at(double t) const {
    using C = std::complex<double>;
    const double W = turning(), n = std::sqrt(g / L + (averaged ? 0 : W * W));
    const auto s = cartesian();
    const C A(s[0], s[1]), B = (C(s[3], s[4]) - C(0, W) * A) / n;
    const C z = std::polar(1.0, W * t) * (A * std::cos(n * t) + B * std::sin(n * t));
    return {z.real(), z.imag()};
  }
};

// ---- integrated -------------------------------------------------------------------------------------------

/// Position and velocity in the turning axes, the rod's tension from |r| = L.
struct Cartesian : Pendulum {
  using State = std::array<double, 6>;
  State start() const { return cartesian(); }
  void operator()(const State& s, State& dsdt, double) const {
    const double wy = w()[1], wz = w()[2], square = wy * wy + wz * wz, along = wy * s[1] + wz * s[2];
    const double ax = -2 * (wy * s[5] - wz * s[4]) + square * s[0];
    const double ay = -2 * wz * s[3] + square * s[1] - wy * along;
    const double az = 2 * wy * s[3] + square * s[2] - wz * along + g;
    const double tension = (s[0] * ax + s[1] * ay + s[2] * az + s[3] * s[3] + s[4] * s[4] + s[5] * s[5]) /
                           (s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
    dsdt = {s[3], s[4], s[5], ax - tension * s[0], ay - tension * s[1], az - tension * s[2]};
  }
  std::array<double, 4> flat(const State& s) const { return {s[0], s[1], s[3], s[4]}; }
  Pair observe(const State& s, double) const { return {s[0], s[1]}; }
  auto conserved(const State& s, double) const {
    const Space<double> r{s[0], s[1], s[2]}, u{s[3], s[4], s[5]}, turned = outer(w(), r);
    return energy_of(inner(u, u) / 2, -inner(turned, turned) / 2 - g * s[2]);
  }
  double off_constraint(const State& s, double) const { return std::abs(std::hypot(s[0], s[1], s[2]) - L); }
};

/// (theta, phi, theta', phi'); with centrifugal = 0 the published equations.
struct TwoAngles : Pendulum {
  double centrifugal = 1;
  using State = std::array<double, 4>;
  State start() const { return {theta, phi, theta_dot, phi_dot}; }
  void operator()(const State& x, State& dxdt, double) const {
    const double c = std::cos(x[1]), s = std::sin(x[1]), ct = std::cos(x[0]), st = std::sin(x[0]);
    const double wy = w()[1], wz = w()[2], wP = wy * ct, wQ = -wy * st * c + wz * s,
                 wR = wy * st * s + wz * c;
    dxdt = {x[2], x[3], (-2 * x[3] * wR - 2 * x[2] * x[3] * c - centrifugal * wP * wR) / s,
            x[2] * x[2] * s * c + 2 * x[2] * s * wR - g / L * s + centrifugal * wQ * wR};
  }
  std::array<double, 4> flat(const State& x) const {
    const auto s = Pendulum{lambda, L, omega, g, x[0], x[1], x[2], x[3]}.cartesian();
    return {s[0], s[1], s[3], s[4]};
  }
  Pair observe(const State& x, double) const {
    return {L * std::cos(x[0]) * std::sin(x[1]), L * std::sin(x[0]) * std::sin(x[1])};
  }
  auto conserved(const State& x, double) const {
    const double s = std::sin(x[1]);
    const auto r = Axes<double>({x[0], x[1]}).R;
    const auto turned = outer(w(), r);
    return energy_of(L * L * (s * s * x[2] * x[2] + x[3] * x[3]) / 2,
                     -L * L * centrifugal * inner(turned, turned) / 2 - g * L * std::cos(x[1]));
  }
};

}  // namespace oddity::foucault
