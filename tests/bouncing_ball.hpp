#pragma once

#include "chapters/own_reference.hpp"
#include "chapters/scene.hpp"
/// A scene with events: a ball falls from y0 to a floor that returns the part e of its speed. Its flights
/// shrink in proportion, and infinitely many of them are over after a finite time.
namespace bouncing_ball {

using namespace oddity;
inline constexpr Parameter parameters[] = {{"y0", 1, "m", "height at release", 0.1, 10},
                                           {"g", 9.81, "m/s^2", "gravity", 1, 100},
                                           {"e", 0.5, "", "part of the speed that is returned", 0, 1}};

template <class T>
struct Given {
  T y0, g, e;
  T fall() const { return sqrt(2 * y0 / g); }
  T rest() const { return fall() * (1 + 2 * e / (1 - e)); }  ///< when the bounces are over
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

inline Quantity height(const Parameters& p, const Horizon& horizon, const Reference&) {
  const Given<double> given{p["y0"], p["g"], p["e"]};
  const Value truth = observe_closed_form(Flights<double>{given}, horizon).value;
  Quantity y = quantity("height", "m", "height at " + times_up_to(horizon), closed_form(truth, 1e-14),
                        {1e-6, "a micrometre"});
  Ladder(y, horizon, halving("step", 0.125, 9), tolerances())
      .closed_form("flights", Flights<double>{given})
      .by_common("ball", Ball<double>{given})
      .by_others("ball", Ball<double>{given});
  return y;
}

inline Scene scene() { return {height, 1, centimeter, "e", {0.25, 0.5}, {"y0"}, {{"y"}, "s", {{"m", {0}}}}}; }

}  // namespace bouncing_ball
