#pragma once

#include <array>
#include <tuple>

#include "chapters/numbers.hpp"

/// The models of exercise 99.98: a mass m on a spring of constant c, released at rest with the stretch x0.
namespace oddity::ex99_98 {

/// The exercise's parameters, in their order.
template <class T>
struct Given {
  T c, m, x0;
};

/// (x, x'), m x'' = -c x.
template <class T>
struct MassOnSpring {
  Given<T> p;
  using State = std::array<T, 2>;
  State start() const { return {p.x0, T(0)}; }
  template <class X>
  void operator()(const std::array<X, 2>& x, std::array<X, 2>& dxdt, const X&) const {
    dxdt = {x[1], -p.c / p.m * x[0]};
  }
  std::array<T, 1> observe(const State& x, const T&) const { return {x[0]}; }
  auto conserved(const State& x, const T&) const {
    return energy_of<T>(p.m * x[1] * x[1] / 2, p.c * x[0] * x[0] / 2);
  }
};

/// From the simplest to the richest.
template <class T>
auto models(const Given<T>& p) {
  return std::tuple{MassOnSpring<T>{p}};
}

}  // namespace oddity::ex99_98
