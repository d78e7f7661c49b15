#pragma once

#include <array>
#include <tuple>

#include "chapters/numbers.hpp"

/// A unit mass on a spring of frequency w, x'' = -w^2 x, from x0 with velocity v0. Used to explain methods:
/// the equation is linear, and a step multiplies (x, v/w) by a matrix.
namespace oddity::oscillator {

template <class T>
struct Given {
  T w, x0, v0;
};

/// (x, v/w) moves on a circle.
template <class T>
struct Circle {
  Given<T> p;
  std::array<T, 2> at(const T& t) const {
    const T c = cos(p.w * t), s = sin(p.w * t);
    return {p.x0 * c + p.v0 / p.w * s, p.v0 * c - p.w * p.x0 * s};
  }
};

/// (x, v).
template <class T>
struct Spring {
  Given<T> p;
  using State = std::array<T, 2>;
  State start() const { return {p.x0, p.v0}; }
  template <class X>
  void operator()(const std::array<X, 2>& x, std::array<X, 2>& dxdt, const X&) const {
    dxdt = {x[1], -p.w * p.w * x[0]};
  }
  template <class X>
  void acceleration(const std::array<X, 1>& q, std::array<X, 1>& dv) const {
    dv = {-p.w * p.w * q[0]};
  }
  std::array<T, 2> observe(const State& x, const T&) const { return x; }
  auto conserved(const State& x, const T&) const {
    return energy_of<T>(x[1] * x[1] / 2, p.w * p.w * x[0] * x[0] / 2);
  }
};

template <class T>
auto models(const Given<T>& p) {
  return std::tuple{Circle<T>{p}, Spring<T>{p}};
}

}  // namespace oddity::oscillator
