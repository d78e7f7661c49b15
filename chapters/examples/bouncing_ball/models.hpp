#pragma once

#include <array>
#include <cstddef>
#include <tuple>

#include "chapters/numbers.hpp"

/// A ball falls from y0 to a floor and bounces with the fraction e of its speed. Its flights shrink
/// geometrically, so infinitely many of them end in a finite time.
namespace oddity::bouncing_ball {

template <class T>
struct Given {
  T y0, g, e;
  T fall() const { return sqrt(2 * y0 / g); }
  T rest() const { return fall() * (1 + 2 * e / (1 - e)); }  ///< the time when the bounces end
};

template <class T>
struct Flights {
  Given<T> p;
  std::array<T, 1> at(T t) const {
    T v(0), y = p.y0, left = p.fall();
    for (T next = p.g * left * p.e; t >= left && left > T(0) && t < p.rest(); next *= p.e) {
      t -= left;
      y = T(0), v = next, left = 2 * v / p.g;
    }
    return {t < left ? T(y + t * (v - p.g * t / 2)) : T(0)};
  }
};

template <class T>
struct Ball {
  Given<T> p;
  using State = std::array<T, 2>;
  State start() const { return {p.y0, T(0)}; }
  void acceleration(const std::array<T, 1>&, std::array<T, 1>& a) const { a = {-p.g}; }
  void operator()(const auto& x, auto& dxdt, const auto&) const { dxdt = {x[1], -p.g}; }
  std::array<T, 1> observe(const State& x, T) const { return {x[0]}; }
  std::array<T, 1> guards(const State& x, T) const { return {x[0]}; }
  Happening<State> at_event(std::size_t, const State& x, T) const { return {{T(0), -p.e * x[1]}}; }
};

/// As in engines: below a centimetre a second the ball stays at rest.
template <class T>
struct ComingToRest : Ball<T> {
  using typename Ball<T>::State;
  Happening<State> at_event(std::size_t i, const State& x, T t) const {
    const State up = Ball<T>::at_event(i, x, t).after;
    return up[1] < T(0.01) ? Happening<State>{{T(0), T(0)}, true} : Happening<State>{up};
  }
};

template <class T>
auto models(const Given<T>& p) {
  return std::tuple{Flights<T>{p}, Ball<T>{p}, ComingToRest<T>{{p}}};
}

}  // namespace oddity::bouncing_ball
