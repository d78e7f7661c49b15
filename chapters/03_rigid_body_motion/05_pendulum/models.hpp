#pragma once

#include <array>
#include <tuple>
#include <vector>

#include "chapters/numbers.hpp"

/// The models of exercise 3.5: a pendulum of length L released at rest from the angle a.
namespace oddity::pendulum {

/// The exercise's parameters.
template <class T>
struct Given {
  T a, L, g;
};

template <class T>
struct SmallAngle {
  Given<T> p;
  std::array<T, 1> at(const T& t) const { return {p.a * cos(sqrt(p.g / p.L) * t)}; }
};

/// The small-angle cosine with the frequency of amplitude a, to order a^2.
template <class T>
struct AmplitudeCorrected {
  Given<T> p;
  std::array<T, 1> at(const T& t) const { return {p.a * cos(sqrt(p.g / p.L) * (1 - p.a * p.a / 16) * t)}; }
};

/// Exact: theta = sum over n of (-1)^n 8 q^(n+1/2) / ((2n+1) (1 + q^(2n+1))) cos((2n+1) w t). The nome is q =
/// exp(-pi K'/K), and w = pi/(2K) sqrt(g/L). It is the integral of 2 k cn u, term by term [DLMF 22.11.2],
/// shifted by a quarter period. The coefficients are computed once.
template <class T>
struct FourierSeries {
  T w;
  std::vector<T> coefficients;

  explicit FourierSeries(const Given<T>& p) {
    const T K = elliptic_K_of_complement<T>(cos(p.a / 2)),
            K_prime = elliptic_K_of_complement<T>(sin(p.a / 2));
    const T pi = T(std::numbers::pi), q = exp(-pi * K_prime / K);
    w = pi / (2 * K) * sqrt(p.g / p.L);
    T size = 8 * sqrt(q), odd = q;
    for (int n = 0; any_of(abs(size) > T(1e-17)); ++n, size *= -q, odd *= q * q)
      coefficients.push_back(select(abs(size) > T(1e-17), T(size / (T(2 * n + 1) * (1 + odd))), T(0)));
  }
  std::array<T, 1> at(const T& t) const {
    const T first = cos(w * t), twice = 4 * first * first - 2;  // 2 cos(2 w t)
    T sum(0), before = first, now = first;
    for (const T& coefficient : coefficients) {
      sum += coefficient * now;
      const T next = twice * now - before;
      before = now;
      now = next;
    }
    return {sum};
  }
};

/// (theta, theta').
template <class T>
struct OneAngle {
  Given<T> p;
  using State = std::array<T, 2>;
  State start() const { return {p.a, T(0)}; }
  template <class X>
  void operator()(const std::array<X, 2>& x, std::array<X, 2>& dxdt, const X&) const {
    dxdt = {x[1], -p.g / p.L * sin(x[0])};
  }
  template <class X>
  void acceleration(const std::array<X, 1>& q, std::array<X, 1>& dv) const {
    dv = {-p.g / p.L * sin(q[0])};
  }
  std::array<T, 1> observe(const State& x, const T&) const { return {x[0]}; }
  auto conserved(const State& x, const T&) const {
    return energy_of<T>(p.L * x[1] * x[1] / 2, -p.g * cos(x[0]));
  }
};

/// (x, y, x', y') with the rod's tension from the constraint x^2 + y^2 = L^2, twice differentiated.
template <class T>
struct CartesianWithConstraint {
  Given<T> p;
  using State = std::array<T, 4>;
  State start() const { return {p.L * sin(p.a), -p.L * cos(p.a), T(0), T(0)}; }
  template <class X>
  void operator()(const std::array<X, 4>& x, std::array<X, 4>& dxdt, const X&) const {
    const X tension = (x[2] * x[2] + x[3] * x[3] - p.g * x[1]) / (x[0] * x[0] + x[1] * x[1]);
    dxdt = {x[2], x[3], -tension * x[0], -tension * x[1] - p.g};
  }
  std::array<T, 1> observe(const State& x, const T&) const { return {atan2(x[0], -x[1])}; }
  auto conserved(const State& x, const T&) const {
    return energy_of<T>((x[2] * x[2] + x[3] * x[3]) / 2, p.g * x[1]);
  }
  std::array<T, 1> constraints(const State& x, const T&) const { return {hypot(x[0], x[1]) - p.L}; }
};

/// From the simplest to the richest.
template <class T>
auto models(const Given<T>& p) {
  return std::tuple{SmallAngle<T>{p}, AmplitudeCorrected<T>{p}, FourierSeries<T>{p}, OneAngle<T>{p},
                    CartesianWithConstraint<T>{p}};
}

}  // namespace oddity::pendulum
