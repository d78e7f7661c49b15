#pragma once

// The models of exercise 3.21.

#include <array>
#include <cmath>

#include "chapters/numbers.hpp"

namespace oddity::pipe_and_disk {

/// Mass m and radius r of the disk, length L and inclination phi of the pipe; on the center act a force f
/// along x and friction -k times its velocity. At the start theta, theta', psi = 0 and psi'.
struct Disk {
  double m, L, r, phi, f, k, theta, theta_dot, psi_dot;

  double mu2() const { return m * r * r / 4; }
  double mu3() const { return m * r * r / 2; }
  double inertia() const { return (m * L * L + mu2()) * std::sin(phi) * std::sin(phi); }
  double spin() const { return psi_dot + theta_dot * std::cos(phi); }
  double spin_energy() const { return mu3() * spin() * spin() / 2; }
  double radius() const { return L * std::sin(phi); }
  std::array<double, 3> seen(double angle, double psi) const {
    return {radius() * std::cos(angle), radius() * std::sin(angle), psi};
  }
};

struct ConstantSpeeds : Disk {
  std::array<double, 3> at(double t) const { return seen(theta + theta_dot * t, psi_dot * t); }
};

/// (theta, psi, theta', psi', work lost to friction): the book's equations.
struct TwoAngles : Disk {
  using State = std::array<double, 5>;
  State start() const { return {theta, 0, theta_dot, psi_dot, 0}; }
  void operator()(const State& x, State& dxdt, double) const {
    const double speed = radius() * x[2];
    const double force = -f * radius() * std::sin(x[0]) - k * radius() * speed;
    dxdt = {x[2], x[3], force / inertia(), -force * std::cos(phi) / inertia(), k * speed * speed};
  }
  std::array<double, 3> observe(const State& x, double) const { return seen(x[0], x[1]); }
  auto conserved(const State& x, double) const {
    const double turn = x[3] + x[2] * std::cos(phi);
    return energy_of(inertia() * x[2] * x[2] / 2 + mu3() * turn * turn / 2,
                     x[4] - f * radius() * std::cos(x[0]));
  }
};

/// (theta, theta'), psi from the conserved spin.
struct OneAngle : Disk {
  using State = std::array<double, 2>;
  State start() const { return {theta, theta_dot}; }
  void operator()(const State& x, State& dxdt, double) const {
    const double arm = radius();
    dxdt = {x[1], (-f * arm * std::sin(x[0]) - k * arm * arm * x[1]) / inertia()};
  }
  std::array<double, 3> observe(const State& x, double t) const {
    return seen(x[0], spin() * t - std::cos(phi) * (x[0] - theta));
  }
};

/// (x, y, x', y', psi, work lost): the center as a mass m + mu2/L^2 on its circle.
struct Center : Disk {
  using State = std::array<double, 6>;
  State start() const {
    const double x = radius() * std::cos(theta), y = radius() * std::sin(theta);
    return {x, y, -y * theta_dot, x * theta_dot, 0, 0};
  }
  double mass() const { return m + mu2() / (L * L); }
  void operator()(const State& s, State& dsdt, double) const {
    const double square = s[0] * s[0] + s[1] * s[1], speeds = s[2] * s[2] + s[3] * s[3];
    const double a = (f - k * s[2]) / mass(), b = -k * s[3] / mass();
    const double inward = (a * s[0] + b * s[1] + speeds) / square;
    const double turning = (s[0] * s[3] - s[1] * s[2]) / square;
    dsdt = {s[2], s[3], a - inward * s[0], b - inward * s[1], spin() - turning * std::cos(phi), k * speeds};
  }
  std::array<double, 3> observe(const State& s, double) const { return {s[0], s[1], s[4]}; }
  auto conserved(const State& s, double) const {
    return energy_of(mass() * (s[2] * s[2] + s[3] * s[3]) / 2 + spin_energy(), s[5] - f * s[0]);
  }
  double off_constraint(const State& s, double) const { return std::abs(std::hypot(s[0], s[1]) - radius()); }
};

}  // namespace oddity::pipe_and_disk
