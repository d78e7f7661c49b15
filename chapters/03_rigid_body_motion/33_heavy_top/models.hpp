#pragma once

// The models of the heavy symmetric top of exercises 3.33 and 3.35. Euler angles: R = Rz(theta) Rx(phi)
// Rz(psi) takes body to world coordinates; the tip is at p(t) = (A sin(lambda t), 0, 0), A = 0 when it is
// fixed; mu1, mu3 are the moments about the tip. Seen from the tip, the forces on the center of mass are -m g
// k - m p''.

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "chapters/numbers.hpp"

namespace oddity::top {

using Vector = std::array<double, 3>;

inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class X>
using Matrix = std::array<std::array<X, 3>, 3>;

template <class X>
Matrix<X> operator*(const Matrix<X>& a, const Matrix<X>& b) {
  Matrix<X> c;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) c[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  return c;
}

/// Rz(theta) Rx(phi) Rz(psi), multiplied out by machine; its last column is the top's axis.
template <class X>
Matrix<X> rotation(const X& theta, const X& phi, const X& psi) {
  using std::cos, std::sin;
  const X zero(0.0), one(1.0);
  const auto about_z = [&](const X& a) {
    return Matrix<X>{{{cos(a), -sin(a), zero}, {sin(a), cos(a), zero}, {zero, zero, one}}};
  };
  const Matrix<X> about_x{{{one, zero, zero}, {zero, cos(phi), -sin(phi)}, {zero, sin(phi), cos(phi)}}};
  return about_z(theta) * about_x * about_z(psi);
}

/// The constants of a top, and its angles and their rates at the start.
struct Top {
  double m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi, A = 0, lambda = 0;

  double spin() const { return dpsi + dtheta * std::cos(phi); }  ///< c
  double a() const { return mu3 * spin() / mu1; }
  double b() const { return a() * std::cos(phi) + dtheta * std::sin(phi) * std::sin(phi); }  ///< gamma/mu1
  double alpha() const { return m * g * l / mu1; }
  double tip_acceleration(double t) const { return -A * lambda * lambda * std::sin(lambda * t); }
  Vector force(double t) const { return {-m * tip_acceleration(t), 0, -m * g}; }

  Vector axis() const {
    return {std::sin(theta) * std::sin(phi), -std::cos(theta) * std::sin(phi), std::cos(phi)};
  }
  /// Angular velocity in body coordinates: phi' along the line of nodes, theta' along k, psi' along the axis.
  Vector body_rates() const {
    const Matrix<double> r = rotation(theta, phi, psi);
    return {dphi * std::cos(psi) + dtheta * r[2][0], -dphi * std::sin(psi) + dtheta * r[2][1],
            dpsi + dtheta * r[2][2]};
  }
  std::vector<double> inputs() const { return {m, l, mu1, mu3, g, theta, phi, psi, dtheta, dphi, dpsi}; }
};

// ---- each observes the axis -------------------------------------------------------------------------------

/// The tilt stays, and the precession has the rate m g l/(mu3 c) of a fast top.
struct MeanPrecession : Top {
  Vector at(double t) const {
    Top now = *this;
    now.theta += m * g * l / (mu3 * spin()) * t;
    return now.axis();
  }
};

/// (phi, phi'): one degree of freedom in an effective potential. Observes the height of the axis.
struct Nutation : Top {
  using State = std::array<double, 2>;
  State start() const { return {phi, dphi}; }
  double precession(double tilt) const {
    return (b() - a() * std::cos(tilt)) / (std::sin(tilt) * std::sin(tilt));
  }
  double tilting(double tilt) const {
    const double rate = precession(tilt);
    return std::sin(tilt) * (alpha() + rate * (rate * std::cos(tilt) - a()));
  }
  void operator()(const State& x, State& dxdt, double) const { dxdt = {x[1], tilting(x[0])}; }
  void acceleration(const std::array<double, 1>& q, std::array<double, 1>& dv) const { dv = {tilting(q[0])}; }
  std::array<double, 1> observe(const State& x, double) const { return {std::cos(x[0])}; }
  auto conserved(const State& x, double) const {
    const double turning = precession(x[0]) * std::sin(x[0]);
    return energy_of(x[1] * x[1] + turning * turning, 2 * alpha() * std::cos(x[0]));
  }
};

/// (u, u'), u = cos(phi): u'' is a polynomial, and the vertical is a point like any other.
struct HeightAlone : Top {
  using State = std::array<double, 2>;
  State start() const { return {std::cos(phi), -std::sin(phi) * dphi}; }
  double constant() const {
    return dphi * dphi + std::pow(dtheta * std::sin(phi), 2) + 2 * alpha() * std::cos(phi);
  }
  void operator()(const State& x, State& dxdt, double) const {
    const double u = x[0];
    dxdt = {x[1], -alpha() * (1 - u * u) - (constant() - 2 * alpha() * u) * u + a() * (b() - a() * u)};
  }
  std::array<double, 1> observe(const State& x, double) const { return {x[0]}; }
};

/// (phi, phi', theta): the precession by quadrature.
struct OneAngle : Nutation {
  using State = std::array<double, 3>;
  State start() const { return {phi, dphi, theta}; }
  /// No partitioned algorithm would carry theta along.
  void acceleration(const std::array<double, 1>&, std::array<double, 1>&) const = delete;
  void operator()(const State& x, State& dxdt, double) const {
    dxdt = {x[1], tilting(x[0]), precession(x[0])};
  }
  Vector observe(const State& x, double) const {
    return {std::sin(x[2]) * std::sin(x[0]), -std::cos(x[2]) * std::sin(x[0]), std::cos(x[0])};
  }
  auto conserved(const State& x, double t) const { return Nutation::conserved({x[0], x[1]}, t); }
};

/// (theta, phi, psi, theta', phi', psi').
struct EulerAngles : Top {
  using State = std::array<double, 6>;
  State start() const { return {theta, phi, psi, dtheta, dphi, dpsi}; }
  void operator()(const State& x, State& dxdt, double t) const {
    const double s = std::sin(x[1]), c = std::cos(x[1]), total = x[5] + x[3] * c;
    const Vector f = force(t);
    const double turning =
        (l * f[0] * std::cos(x[0]) - 2 * mu1 * x[3] * x[4] * c + mu3 * total * x[4]) / (mu1 * s);
    const double tilting =
        (l * (f[0] * std::sin(x[0]) * c - f[2] * s) - mu3 * total * x[3] * s) / mu1 + x[3] * x[3] * s * c;
    dxdt = {x[3], x[4], x[5], turning, tilting, x[3] * x[4] * s - turning * c};
  }
  Vector observe(const State& x, double) const {
    return {std::sin(x[0]) * std::sin(x[1]), -std::cos(x[0]) * std::sin(x[1]), std::cos(x[1])};
  }
  /// The spin momentum; with a tip at rest the energy too, of which the axis' part moves.
  std::array<Conserved<double>, 2> conserved(const State& x, double) const {
    const double s = std::sin(x[1]), c = std::cos(x[1]), total = x[5] + x[3] * c;
    const double across = mu1 * std::hypot(x[4], x[3] * s), spin = mu3 * total;
    const double kinetic = across * across / (2 * mu1);
    return {{{spin, std::hypot(spin, across)},
             A != 0 ? Conserved<double>{0, 0} : Conserved<double>{kinetic + spin * total / 2 + m * g * l * c, kinetic}}};
  }
};

/// (axis, angular momentum about the tip): d' = L x d/mu1, L' = l d x F. The spin is L.d.
struct AxisAndMomentum : Top {
  using State = std::array<double, 6>;
  State start() const {
    const Vector d = axis(), w = body_rates();
    const Matrix<double> r = rotation(theta, phi, psi);
    State x{d[0], d[1], d[2], 0, 0, 0};
    for (std::size_t i = 0; i < 3; ++i)
      x[3 + i] = mu1 * (r[i][0] * w[0] + r[i][1] * w[1]) + mu3 * r[i][2] * w[2];
    return x;
  }
  void operator()(const State& x, State& dxdt, double t) const {
    const Vector d{x[0], x[1], x[2]}, turn = cross({x[3], x[4], x[5]}, d), torque = cross(d, force(t));
    dxdt = {turn[0] / mu1, turn[1] / mu1, turn[2] / mu1, l * torque[0], l * torque[1], l * torque[2]};
  }
  Vector observe(const State& x, double) const { return {x[0], x[1], x[2]}; }
  /// The spin momentum.
  std::array<Conserved<double>, 1> conserved(const State& x, double) const {
    return {{{x[0] * x[3] + x[1] * x[4] + x[2] * x[5], std::hypot(x[3], x[4], x[5])}}};
  }
  /// Of the center of mass, which is to stay at the distance l from the tip.
  double off_constraint(const State& x, double) const {
    return l * std::abs(std::hypot(x[0], x[1], x[2]) - 1);
  }
};

/// (quaternion, angular velocity in body coordinates): Euler's equations with the torque about the tip.
struct RigidBody : Top {
  using State = std::array<double, 7>;
  State start() const {
    const double half = phi / 2, sum = (theta + psi) / 2, difference = (theta - psi) / 2;
    const Vector w = body_rates();
    return {std::cos(half) * std::cos(sum),
            std::sin(half) * std::cos(difference),
            std::sin(half) * std::sin(difference),
            std::cos(half) * std::sin(sum),
            w[0],
            w[1],
            w[2]};
  }
  void operator()(const State& x, State& dxdt, double t) const {
    const auto [q, i, j, k, w1, w2, w3] = x;
    const Vector f = force(t);
    const double f1 = (1 - 2 * (j * j + k * k)) * f[0] + 2 * (i * k - q * j) * f[2];
    const double f2 = 2 * (i * j - q * k) * f[0] + 2 * (j * k + q * i) * f[2];
    dxdt = {(-i * w1 - j * w2 - k * w3) / 2,
            (q * w1 + j * w3 - k * w2) / 2,
            (q * w2 + k * w1 - i * w3) / 2,
            (q * w3 + i * w2 - j * w1) / 2,
            ((mu1 - mu3) * w2 * w3 - l * f2) / mu1,
            ((mu3 - mu1) * w3 * w1 + l * f1) / mu1,
            0};
  }
  Vector observe(const State& x, double) const {
    const double norm = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3];
    return {2 * (x[1] * x[3] + x[0] * x[2]) / norm, 2 * (x[2] * x[3] - x[0] * x[1]) / norm,
            1 - 2 * (x[1] * x[1] + x[2] * x[2]) / norm};
  }
  /// The quaternion's square; with a tip at rest the energy too, of which the axis' part moves.
  std::array<Conserved<double>, 2> conserved(const State& x, double t) const {
    const double square = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3];
    const double kinetic = mu1 * (x[4] * x[4] + x[5] * x[5]) / 2;
    return {{{square, 1},
             A != 0 ? Conserved<double>{0, 0}
                    : Conserved<double>{kinetic + mu3 * x[6] * x[6] / 2 + m * g * l * observe(x, t)[2], kinetic}}};
  }
};

}  // namespace oddity::top
