#pragma once

#include <array>
#include <tuple>

#include "chapters/numbers.hpp"

/// The models of exercise 3.21. Mass m and radius r of the disk, length L and inclination phi of the pipe. A
/// force f along x and friction -k times its velocity act on the center. Initial values are theta, theta',
/// psi = 0 and psi'.
namespace oddity::pipe_and_disk {

template <class T>
struct Given {
  T m, L, r, phi, f, k, theta, theta_dot, psi_dot;

  T mu2() const { return m * r * r / 4; }
  T mu3() const { return m * r * r / 2; }
  T inertia() const { return (m * L * L + mu2()) * sin(phi) * sin(phi); }
  T spin() const { return psi_dot + theta_dot * cos(phi); }
  T spin_energy() const { return mu3() * spin() * spin() / 2; }
  T radius() const { return L * sin(phi); }
  std::array<T, 3> seen(const T& angle, const T& psi) const {
    return {radius() * cos(angle), radius() * sin(angle), psi};
  }
};

template <class T>
struct ConstantSpeeds {
  Given<T> p;
  std::array<T, 3> at(const T& t) const { return p.seen(p.theta + p.theta_dot * t, p.psi_dot * t); }
};

/// (theta, theta'), with psi from the conserved spin.
template <class T>
struct OneAngle {
  Given<T> p;
  T arm = p.radius(), inertia = p.inertia();
  using State = std::array<T, 2>;
  State start() const { return {p.theta, p.theta_dot}; }
  template <class X>
  void operator()(const std::array<X, 2>& x, std::array<X, 2>& dxdt, const X&) const {
    dxdt = {x[1], (-p.f * arm * sin(x[0]) - p.k * arm * arm * x[1]) / inertia};
  }
  std::array<T, 3> observe(const State& x, const T& t) const {
    return p.seen(x[0], p.spin() * t - cos(p.phi) * (x[0] - p.theta));
  }
};

/// (theta, psi, theta', psi', work lost to friction): the book's equations.
template <class T>
struct TwoAngles {
  Given<T> p;
  T arm = p.radius(), inertia = p.inertia(), cosine = cos(p.phi);
  using State = std::array<T, 5>;
  State start() const { return {p.theta, T(0), p.theta_dot, p.psi_dot, T(0)}; }
  template <class X>
  void operator()(const std::array<X, 5>& x, std::array<X, 5>& dxdt, const X&) const {
    const X speed = arm * x[2];
    const X force = -p.f * arm * sin(x[0]) - p.k * arm * speed;
    dxdt = {x[2], x[3], force / inertia, -force * cosine / inertia, p.k * speed * speed};
  }
  std::array<T, 3> observe(const State& x, const T&) const { return p.seen(x[0], x[1]); }
  auto conserved(const State& x, const T&) const {
    const T turn = x[3] + x[2] * cosine;
    return energy_of<T>(inertia * x[2] * x[2] / 2 + p.mu3() * turn * turn / 2, x[4] - p.f * arm * cos(x[0]));
  }
};

/// (x, y, x', y', psi, work lost): the center as a mass m + mu2/L^2 on its circle.
template <class T>
struct Center {
  Given<T> p;
  T mass = p.m + p.mu2() / (p.L * p.L), spin = p.spin(), cosine = cos(p.phi);
  using State = std::array<T, 6>;
  State start() const {
    const T x = p.radius() * cos(p.theta), y = p.radius() * sin(p.theta);
    return {x, y, -y * p.theta_dot, x * p.theta_dot, T(0), T(0)};
  }
  template <class X>
  void operator()(const std::array<X, 6>& s, std::array<X, 6>& dsdt, const X&) const {
    const X square = s[0] * s[0] + s[1] * s[1], speeds = s[2] * s[2] + s[3] * s[3];
    const X a = (p.f - p.k * s[2]) / mass, b = -p.k * s[3] / mass;
    const X inward = (a * s[0] + b * s[1] + speeds) / square;
    const X turning = (s[0] * s[3] - s[1] * s[2]) / square;
    dsdt = {s[2], s[3], a - inward * s[0], b - inward * s[1], spin - turning * cosine, p.k * speeds};
  }
  std::array<T, 3> observe(const State& s, const T&) const { return {s[0], s[1], s[4]}; }
  auto conserved(const State& s, const T&) const {
    return energy_of<T>(mass * (s[2] * s[2] + s[3] * s[3]) / 2 + p.spin_energy(), s[5] - p.f * s[0]);
  }
  std::array<T, 1> constraints(const State& s, const T&) const { return {hypot(s[0], s[1]) - p.radius()}; }
};

/// From the simplest to the richest.
template <class T>
auto models(const Given<T>& p) {
  return std::tuple{ConstantSpeeds<T>{p}, OneAngle<T>{p}, TwoAngles<T>{p}, Center<T>{p}};
}

}  // namespace oddity::pipe_and_disk
