#pragma once

// The models of exercise 3.29.

#include <array>
#include <cmath>

#include "chapters/numbers.hpp"

namespace oddity::planar_wire {

using Point = std::array<double, 2>;

/// mu0, the center of mass, mu2 about it.
using Inertia = std::array<double, 4>;

/// From mu0 and the moments int x, int y, int (x^2 + y^2).
inline Inertia about_center(double m0, double mx, double my, double m2) {
  const double cx = mx / m0, cy = my / m0;
  return {m0, cx, cy, m2 - m0 * (cx * cx + cy * cy)};
}

/// Of y = x^2 from 0 to q, the density d0 uniform, by the primitives of the moments.
inline Inertia inertia_of_parabola(double q, double d0) {
  const double z = 2 * q, root = std::sqrt(1 + z * z), arsinh = std::asinh(z);
  const double z2 = (z * (2 * z * z + 1) * root - arsinh) / 8;    // of z^2 sqrt(1 + z^2)
  const double z4 = z * z * z * root * root * root / 6 - z2 / 2;  // of z^4 sqrt(1 + z^2)
  return about_center(d0 * (z * root + arsinh) / 4, d0 * (root * root * root - 1) / 12, d0 * z2 / 8,
                      d0 * (z2 / 8 + z4 / 32));
}

/// A wire thrown from the center c with velocity (u, v), turning with w from the angle 0. Its mark, at b in
/// the body, is what is looked at.
struct Thrown {
  double mu0, mu2, u, v, w, g;
  Point b;

  Point mark(double x, double y, double theta) const {
    const double C = std::cos(theta), S = std::sin(theta);
    return {x + C * b[0] - S * b[1], y + S * b[0] + C * b[1]};
  }
};

/// The parabola from 0 to q, marked at its first end.
inline Thrown thrown_parabola(double q, double d0, double u, double v, double w, double g) {
  const Inertia i = inertia_of_parabola(q, d0);
  return {i[0], i[3], u, v, w, g, {-i[1], -i[2]}};
}

struct FreeFall : Thrown {
  Point at(double t) const { return mark(u * t, v * t - g * t * t / 2, w * t); }
};

/// The wire as its center of mass alone.
struct PointMass : Thrown {
  Point at(double t) const { return mark(u * t, v * t - g * t * t / 2, 0); }
};

/// (x, y, theta, x', y', theta').
struct Generalized : Thrown {
  using State = std::array<double, 6>;
  State start() const { return {0, 0, 0, u, v, w}; }
  void operator()(const State& x, State& dxdt, double) const { dxdt = {x[3], x[4], x[5], 0, -g, 0}; }
  void acceleration(const std::array<double, 3>&, std::array<double, 3>& a) const { a = {0, -g, 0}; }
  Point observe(const State& x, double) const { return mark(x[0], x[1], x[2]); }
  auto conserved(const State& x, double) const {
    return energy_of(mu0 * (x[3] * x[3] + x[4] * x[4]) / 2 + mu2 * x[5] * x[5] / 2, mu0 * g * x[1]);
  }
};

/// Two particles of mu0/2 with the same moments, (x1, y1, x2, y2) and velocities, at the distance 2 sqrt(mu2
/// / mu0) that a massless rod holds: the constraint, twice differentiated.
struct TwoParticles : Thrown {
  using State = std::array<double, 8>;
  double k() const { return std::sqrt(mu2 / mu0); }
  State start() const { return {k(), 0, -k(), 0, u, v + w * k(), u, v - w * k()}; }
  void operator()(const State& x, State& dxdt, double) const {
    const double dx = x[0] - x[2], dy = x[1] - x[3], du = x[4] - x[6], dv = x[5] - x[7];
    const double hold = (du * du + dv * dv) / (dx * dx + dy * dy) / 2;
    dxdt = {x[4], x[5], x[6], x[7], -hold * dx, -hold * dy - g, hold * dx, hold * dy - g};
  }
  Point observe(const State& x, double) const {
    return mark((x[0] + x[2]) / 2, (x[1] + x[3]) / 2, std::atan2(x[1] - x[3], x[0] - x[2]));
  }
  auto conserved(const State& x, double) const {
    return energy_of(mu0 / 4 * (x[4] * x[4] + x[5] * x[5] + x[6] * x[6] + x[7] * x[7]),
                     mu0 * g * (x[1] + x[3]) / 2);
  }
  double off_constraint(const State& x, double) const {
    return std::abs(std::hypot(x[0] - x[2], x[1] - x[3]) - 2 * k());
  }
};

}  // namespace oddity::planar_wire
