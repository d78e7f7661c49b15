#pragma once

#include <array>
#include <cmath>
#include <stdexcept>

#include "chapters/numbers.hpp"

/// A ball in the plane on a spring of constant c with viscous friction a: m x'' + a x' + c x = 0 from p with
/// velocity v.
namespace oddity::damped_ball {

struct Ball {
  double m, c, a, p1, p2, v1, v2;
};

/// The three regimes in one form, without cancellation where they meet: exp(-h t)(p C + (v + h p) S).
/// Over-damped, the slow exponential is taken out of C and S; its rate h - w is (c/m)/(h + w).
struct OneForm : Ball {
  std::array<double, 2> at(double t) const {
    const double h = a / (2 * m), d = h * h - c / m, w = std::sqrt(std::abs(d));
    const double rate = d > 0 ? c / m / (h + w) : h;
    const double even = d > 0 ? (1 + std::exp(-2 * w * t)) / 2 : std::cos(w * t);
    const double odd = w == 0 ? t : d > 0 ? -std::expm1(-2 * w * t) / (2 * w) : std::sin(w * t) / w;
    const auto x = [&](double p, double v) { return std::exp(-rate * t) * (p * even + (v + h * p) * odd); };
    return {x(p1, v1), x(p2, v2)};
  }
};

/// The book's case 1: K1 exp(r1 t) + K2 exp(r2 t), as written; raised where the roots are complex.
struct TwoExponentials : Ball {
  std::array<double, 2> at(double t) const {
    if (a * a < 4 * m * c) throw std::domain_error("the roots are complex: a^2 < 4 m c");
    const double root = std::sqrt(a * a - 4 * m * c), r1 = (-a + root) / (2 * m), r2 = (-a - root) / (2 * m);
    const auto x = [&](double p, double v) {
      const double k1 = (v - r2 * p) / (r1 - r2);
      return k1 * std::exp(r1 * t) + (p - k1) * std::exp(r2 * t);
    };
    return {x(p1, v1), x(p2, v2)};
  }
};

/// (x1, x2, x1', x2').
struct Plane : Ball {
  using State = std::array<double, 4>;
  State start() const { return {p1, p2, v1, v2}; }
  template <class X, class T>
  void operator()(const X& x, X& dxdt, const T&) const {
    dxdt = {x[2], x[3], (-c * x[0] - a * x[2]) / m, (-c * x[1] - a * x[3]) / m};
  }
  std::array<double, 2> observe(const State& x, double) const { return {x[0], x[1]}; }
};

/// (x1, x2, x1', x2', work lost to friction): with it the energy is conserved.
struct PlaneWithWork : Ball {
  using State = std::array<double, 5>;
  State start() const { return {p1, p2, v1, v2, 0}; }
  template <class X, class T>
  void operator()(const X& x, X& dxdt, const T&) const {
    dxdt = {x[2], x[3], (-c * x[0] - a * x[2]) / m, (-c * x[1] - a * x[3]) / m,
            a * (x[2] * x[2] + x[3] * x[3])};
  }
  std::array<double, 2> observe(const State& x, double) const { return {x[0], x[1]}; }
  auto conserved(const State& x, double) const {
    return energy_of(m * (x[2] * x[2] + x[3] * x[3]) / 2, c * (x[0] * x[0] + x[1] * x[1]) / 2 + x[4]);
  }
};

}  // namespace oddity::damped_ball
