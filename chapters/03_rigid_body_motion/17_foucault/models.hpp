#pragma once

#include <array>
#include <tuple>
#include <vector>

#include "chapters/numbers.hpp"

/// The models of exercise 3.17: a pendulum of length L at the latitude lambda of an Earth that rotates at
/// omega. Axes: x west, y north, z down; w = omega (0, cos lambda, -sin lambda). The angle theta is about the
/// vertical, from west to north; phi is measured from the downward vertical.
namespace oddity::foucault {

/// The book's three axes; the bob is at L R.
template <class T>
struct Axes {
  std::array<T, 3> P, Q, R;
  explicit Axes(const std::array<T, 2>& q) {
    const T c = cos(q[0]), s = sin(q[0]), cp = cos(q[1]), sp = sin(q[1]);
    P = {-s, c, T(0)};
    Q = {-c * cp, -s * cp, sp};
    R = {c * sp, s * sp, cp};
  }
};

template <class T>
struct Given {
  T lambda, L, omega, g, theta, phi, theta_dot, phi_dot;

  std::vector<T> inputs() const { return {lambda, L, omega, g, theta, phi, theta_dot, phi_dot}; }
  std::array<T, 3> w() const { return {T(0), omega * cos(lambda), -omega * sin(lambda)}; }
  std::array<T, 6> cartesian() const {
    const T c = cos(theta), s = sin(theta), cp = cos(phi), sp = sin(phi);
    return {L * (c * sp),
            L * (s * sp),
            L * cp,
            L * (-s * theta_dot * sp + c * (cp * phi_dot)),
            L * (c * theta_dot * sp + s * (cp * phi_dot)),
            L * (-sp * phi_dot)};
  }
};

/// z'' = 2i W z' - (g/L) z for z = x + iy, W = omega sin lambda. The solution is exp(iWt)(A cos nt + B sin
/// nt) with n^2 = g/L + W^2. Averaged, n^2 = g/L: the free ellipse in axes that rotate with W.
template <class T>
struct SmallAngle {
  Given<T> p;
  bool averaged = false;
  std::array<T, 2> at(const T& t) const {
    const T W = p.omega * sin(p.lambda), n = sqrt(p.g / p.L + (averaged ? T(0) : W * W));
    const auto s = p.cartesian();
    const T C = cos(n * t), S = sin(n * t), c = cos(W * t), d = sin(W * t);
    const T along = s[0] * C + (s[3] + W * s[1]) / n * S, across = s[1] * C + (s[4] - W * s[0]) / n * S;
    return {c * along - d * across, c * across + d * along};
  }
  /// Relative to the pivot, for the drawing.
  std::array<T, 3> place(const T& t) const {
    const auto [x, y] = at(t);
    return {x, y, sqrt(p.L * p.L - x * x - y * y)};
  }
};

/// (theta, phi, theta', phi'); the published equations if `centrifugal` is 0.
template <class T>
struct TwoAngles {
  Given<T> p;
  T centrifugal = T(1);
  std::array<T, 3> w = p.w();
  T pull = p.g / p.L;
  using State = std::array<T, 4>;
  State start() const { return {p.theta, p.phi, p.theta_dot, p.phi_dot}; }
  template <class X>
  void operator()(const std::array<X, 4>& x, std::array<X, 4>& dxdt, const X&) const {
    const X c = cos(x[1]), s = sin(x[1]), ct = cos(x[0]), st = sin(x[0]);
    const X level = w[1] * st, wP = w[1] * ct, wQ = w[2] * s - level * c, wR = level * s + w[2] * c;
    const X outward = centrifugal * wR, turn = wR + x[2] * c;
    dxdt = {x[2], x[3], -(2 * x[3] * turn + wP * outward) / s,
            s * (x[2] * (turn + wR) - pull) + wQ * outward};
  }
  /// (x, y, x', y')
  std::array<T, 4> flat(const State& x) const {
    const auto s = Given<T>{p.lambda, p.L, p.omega, p.g, x[0], x[1], x[2], x[3]}.cartesian();
    return {s[0], s[1], s[3], s[4]};
  }
  std::array<T, 2> observe(const State& x, const T&) const {
    return {p.L * cos(x[0]) * sin(x[1]), p.L * sin(x[0]) * sin(x[1])};
  }
  std::array<T, 3> place(const State& x, const T& t) const {
    const auto [west, north] = observe(x, t);
    return {west, north, p.L * cos(x[1])};
  }
  auto conserved(const State& x, const T&) const {
    const T s = sin(x[1]);
    const auto turned = cross(w, Axes<T>({x[0], x[1]}).R);
    return energy_of<T>(p.L * p.L * (s * s * x[2] * x[2] + x[3] * x[3]) / 2,
                        -p.L * p.L * centrifugal * dot(turned, turned) / 2 - p.g * p.L * cos(x[1]));
  }
};

/// Position and velocity in the rotating axes, with the rod's tension from |r| = L.
template <class T>
struct Cartesian {
  Given<T> p;
  std::array<T, 3> w = p.w();
  T square = w[1] * w[1] + w[2] * w[2];
  using State = std::array<T, 6>;
  State start() const { return p.cartesian(); }
  template <class X>
  void operator()(const std::array<X, 6>& s, std::array<X, 6>& dsdt, const X&) const {
    // -2 w x r' - w x (w x r) + g, whose parts along y and z have a common factor
    const X across = w[2] * s[1] - w[1] * s[2] - 2 * s[3];
    const X ax = 2 * (w[2] * s[4] - w[1] * s[5]) + square * s[0], ay = w[2] * across,
            az = p.g - w[1] * across;
    const X tension = (s[0] * ax + s[1] * ay + s[2] * az + s[3] * s[3] + s[4] * s[4] + s[5] * s[5]) /
                      (s[0] * s[0] + s[1] * s[1] + s[2] * s[2]);
    dsdt = {s[3], s[4], s[5], ax - tension * s[0], ay - tension * s[1], az - tension * s[2]};
  }
  /// (x, y, x', y')
  std::array<T, 4> flat(const State& s) const { return {s[0], s[1], s[3], s[4]}; }
  std::array<T, 2> observe(const State& s, const T&) const { return {s[0], s[1]}; }
  std::array<T, 3> place(const State& s, const T&) const { return {s[0], s[1], s[2]}; }
  auto conserved(const State& s, const T&) const {
    const std::array<T, 3> r{s[0], s[1], s[2]}, u{s[3], s[4], s[5]}, turned = cross(w, r);
    return energy_of<T>(dot(u, u) / 2, -dot(turned, turned) / 2 - p.g * s[2]);
  }
  std::array<T, 1> constraints(const State& s, const T&) const { return {hypot(s[0], s[1], s[2]) - p.L}; }
};

/// From the simplest to the richest.
template <class T>
auto models(const Given<T>& p) {
  return std::tuple{SmallAngle<T>{p, true}, SmallAngle<T>{p}, TwoAngles<T>{p, T(0)}, TwoAngles<T>{p},
                    Cartesian<T>{p}};
}

}  // namespace oddity::foucault
