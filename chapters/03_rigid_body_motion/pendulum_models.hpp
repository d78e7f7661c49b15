#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "chapters/conserved.hpp"

/// A pendulum of length L let go at rest from the angle a: closed forms and models to be integrated.
namespace oddity::pendulum {

struct Pendulum {
  double a, L, g;
};

struct SmallAngle : Pendulum {
  std::array<double, 1> at(double t) const { return {a * std::cos(std::sqrt(g / L) * t)}; }
};

/// The small angle's cosine at the frequency of amplitude a, to order a^2.
struct AmplitudeCorrected : Pendulum {
  std::array<double, 1> at(double t) const { return {a * std::cos(std::sqrt(g / L) * (1 - a * a / 16) * t)}; }
};

/// Exact: theta = sum over n of (-1)^n 8 q^(n+1/2) / ((2n+1) (1 + q^(2n+1))) cos((2n+1) w t) with the nome
/// q = exp(-pi K'/K), w = pi/(2K) sqrt(g/L). It is the integral of 2 k cn u, term by term [DLMF 22.11.2],
/// seen from a quarter period later. The coefficients are made once.
struct FourierSeries : Pendulum {
  double w;
  std::vector<double> coefficients;

  explicit FourierSeries(const Pendulum& pendulum) : Pendulum(pendulum) {
    const double K = std::comp_ellint_1(std::sin(a / 2)), K_prime = std::comp_ellint_1(std::cos(a / 2));
    const double q = std::exp(-std::numbers::pi * K_prime / K);
    w = std::numbers::pi / (2 * K) * std::sqrt(g / L);
    double size = 8 * std::sqrt(q), odd = q;
    for (int n = 0; std::abs(size) > 1e-17; ++n, size *= -q, odd *= q * q)
      coefficients.push_back(size / ((2 * n + 1) * (1 + odd)));
  }
  std::array<double, 1> at(double t) const {
    const double first = std::cos(w * t), twice = 4 * first * first - 2;  // 2 cos(2 w t)
    double sum = 0, before = first, now = first;
    for (double coefficient : coefficients) {
      sum += coefficient * now;
      const double next = twice * now - before;
      before = now;
      now = next;
    }
    return {sum};
  }
};

/// (theta, theta').
struct OneAngle : Pendulum {
  using State = std::array<double, 2>;
  State start() const { return {a, 0}; }
  void operator()(const State& x, State& dxdt, double) const { dxdt = {x[1], -g / L * std::sin(x[0])}; }
  void acceleration(const std::array<double, 1>& q, std::array<double, 1>& dv) const {
    dv = {-g / L * std::sin(q[0])};
  }
  std::array<double, 1> observe(const State& x, double) const { return {x[0]}; }
  OneConserved conserved(const State& x, double) const {
    return energy_of(L * x[1] * x[1] / 2, -g * std::cos(x[0]));
  }
};

/// (x, y, x', y') with the rod's tension from the constraint x^2 + y^2 = L^2, twice differentiated.
struct CartesianWithConstraint : Pendulum {
  using State = std::array<double, 4>;
  State start() const { return {L * std::sin(a), -L * std::cos(a), 0, 0}; }
  void operator()(const State& x, State& dxdt, double) const {
    const double tension = (x[2] * x[2] + x[3] * x[3] - g * x[1]) / (x[0] * x[0] + x[1] * x[1]);
    dxdt = {x[2], x[3], -tension * x[0], -tension * x[1] - g};
  }
  std::array<double, 1> observe(const State& x, double) const { return {std::atan2(x[0], -x[1])}; }
  OneConserved conserved(const State& x, double) const {
    return energy_of((x[2] * x[2] + x[3] * x[3]) / 2, g * x[1]);
  }
  double off_constraint(const State& x, double) const { return std::abs(std::hypot(x[0], x[1]) - L); }
};

}  // namespace oddity::pendulum
