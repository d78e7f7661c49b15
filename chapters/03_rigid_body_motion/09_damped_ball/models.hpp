#pragma once

#include <array>
#include <tuple>

#include "chapters/numbers.hpp"

/// The models of exercise 3.9: a ball in the plane on a spring of constant c with viscous friction a. Its
/// motion is m x'' + a x' + c x = 0 from p with velocity v.
namespace oddity::damped_ball {

/// The exercise's parameters.
template <class T>
struct Given {
  T m, c, a, p1, p2, v1, v2;
};

/// The book's case 1: K1 exp(r1 t) + K2 exp(r2 t), as written; NaN for complex roots.
template <class T>
struct TwoExponentials {
  Given<T> p;
  std::array<T, 2> at(const T& t) const {
    const auto& [m, c, a, p1, p2, v1, v2] = p;
    const T root = sqrt(a * a - 4 * m * c), r1 = (-a + root) / (2 * m), r2 = (-a - root) / (2 * m);
    const auto x = [&](const T& from, const T& v) -> T {
      const T k1 = (v - r2 * from) / (r1 - r2);
      return k1 * exp(r1 * t) + (from - k1) * exp(r2 * t);
    };
    return {x(p1, v1), x(p2, v2)};
  }
};

/// The three regimes in one form, without cancellation where they meet: exp(-h t)(p C + (v + h p) S). In the
/// overdamped case the slow exponential is factored out of C and S; its rate h - w is (c/m)/(h + w).
template <class T>
struct OneForm {
  Given<T> p;
  std::array<T, 2> at(const T& t) const {
    const auto& [m, c, a, p1, p2, v1, v2] = p;
    const T h = a / (2 * m), d = h * h - c / m, w = sqrt(abs(d)), zero(0);
    const T rate = select(d > zero, T(c / m / (h + w)), h);
    const T even = select(d > zero, T((1 + exp(-2 * w * t)) / 2), T(cos(w * t)));
    const T odd = select(d > zero, T(-expm1(-2 * w * t) / (2 * w)), T(sin(w * t) / w));
    const T turned = select(w > zero, odd, t);
    const auto x = [&](const T& from, const T& v) -> T {
      return exp(-rate * t) * (from * even + (v + h * from) * turned);
    };
    return {x(p1, v1), x(p2, v2)};
  }
};

/// (x1, x2, x1', x2').
template <class T>
struct Plane {
  Given<T> p;
  using State = std::array<T, 4>;
  State start() const { return {p.p1, p.p2, p.v1, p.v2}; }
  template <class X>
  void operator()(const std::array<X, 4>& x, std::array<X, 4>& dxdt, const X&) const {
    dxdt = {x[2], x[3], (-p.c * x[0] - p.a * x[2]) / p.m, (-p.c * x[1] - p.a * x[3]) / p.m};
  }
  std::array<T, 2> observe(const State& x, const T&) const { return {x[0], x[1]}; }
};

/// (x1, x2, x1', x2', work lost to friction), for which the energy is conserved.
template <class T>
struct PlaneWithWork {
  Given<T> p;
  using State = std::array<T, 5>;
  State start() const { return {p.p1, p.p2, p.v1, p.v2, T(0)}; }
  template <class X>
  void operator()(const std::array<X, 5>& x, std::array<X, 5>& dxdt, const X&) const {
    dxdt = {x[2], x[3], (-p.c * x[0] - p.a * x[2]) / p.m, (-p.c * x[1] - p.a * x[3]) / p.m,
            p.a * (x[2] * x[2] + x[3] * x[3])};
  }
  std::array<T, 2> observe(const State& x, const T&) const { return {x[0], x[1]}; }
  auto conserved(const State& x, const T&) const {
    return energy_of<T>(p.m * (x[2] * x[2] + x[3] * x[3]) / 2, p.c * (x[0] * x[0] + x[1] * x[1]) / 2 + x[4]);
  }
};

/// From the simplest to the richest, without the two exponentials, which are NaN for some frictions.
template <class T>
auto models(const Given<T>& p) {
  return std::tuple{OneForm<T>{p}, Plane<T>{p}, PlaneWithWork<T>{p}};
}

}  // namespace oddity::damped_ball
