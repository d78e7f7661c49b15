#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "solvers/taylor/tape.hpp"

/// Initial value problems with known solutions, all of one type, so that every algorithm is compiled once.
namespace problems {

using State = std::array<double, 2>;

/// A right-hand side by function pointer that counts its calls; as (q, v) it is also a partitioned system. If
/// made from a generic function, it also accepts numbers of a tape.
struct System {
  using Number = oddity::taylor::Recorded;
  using Numbers = std::array<Number, 2>;

  void (*f)(const State& x, State& dxdt, double t);
  void (*on_tape)(const Numbers& x, Numbers& dxdt, Number t) = nullptr;
  mutable long calls = 0;

  void operator()(const Numbers& x, Numbers& dxdt, const Number& t) const {
    if (!on_tape) throw std::logic_error("the problem is not of a generic function");
    on_tape(x, dxdt, t);
  }
  void operator()(const State& x, State& dxdt, double t) const {
    ++calls;
    f(x, dxdt, t);
  }
  void acceleration(const std::array<double, 1>& q, std::array<double, 1>& a) const {
    State dxdt{};
    (*this)({q[0], 0}, dxdt, 0);
    a[0] = dxdt[1];
  }
};

template <class F>
System generic(F f) {
  return {f, f};
}

struct Problem {
  System system;
  State (*exact)(double t);
};

/// theta'' = -sin(theta) on its way between its two unstable equilibria: theta = 2 asin(tanh t).
inline const Problem separatrix{generic([](const auto& x, auto& dxdt, auto) {
                                  using std::sin;
                                  dxdt = {x[1], -sin(x[0])};
                                }),
                                [](double t) -> State {
                                  return {2 * std::asin(std::tanh(t)), 2 / std::cosh(t)};
                                }};

inline const Problem oscillator{generic([](const auto& x, auto& dxdt, auto) {
                                  dxdt = {x[1], -x[0]};
                                }),
                                [](double t) -> State {
                                  return {std::cos(t), -std::sin(t)};
                                }};

inline const Problem decay{generic([](const auto& x, auto& dxdt, auto) {
                             dxdt = {-x[0], -x[1]};
                           }),
                           [](double t) -> State {
                             return {std::exp(-t), std::exp(-t)};
                           }};

/// Two equations with explicit time.
inline const Problem driven{generic([](const auto& x, auto& dxdt, auto t) {
                              using std::cos, std::sin;
                              dxdt = {x[0] * cos(t), -x[1] * sin(t)};
                            }),
                            [](double t) -> State {
                              return {std::exp(std::sin(t)), std::exp(std::cos(t))};
                            }};

/// Two integrals over time: invisible to an embedded estimator that compares stages at the same times.
inline const Problem clocked{generic([](const auto&, auto& dxdt, auto t) {
                               using std::cos, std::exp;
                               dxdt = {cos(t), exp(-t)};
                             }),
                             [](double t) -> State {
                               return {std::sin(t), -std::exp(-t)};
                             }};

/// q'' = cos t: an integral of an integral over time.
inline const Problem pushed{generic([](const auto& x, auto& dxdt, auto t) {
                              using std::cos;
                              dxdt = {x[1], cos(t)};
                            }),
                            [](double t) -> State {
                              return {-std::cos(t), std::sin(t)};
                            }};

/// q'' = -q' - q, from q = 1: forces that depend on the velocity.
inline const Problem damped{
    generic([](const auto& x, auto& dxdt, auto) {
      dxdt = {x[1], -x[0] - x[1]};
    }),
    [](double t) -> State {
      const double w = std::sqrt(0.75), fades = std::exp(-t / 2);
      return {fades * (std::cos(w * t) + std::sin(w * t) / (2 * w)), -fades * std::sin(w * t) / w};
    }};

/// Prothero and Robinson's problem, mildly stiff: the solution cos t attracts at the rate 1000.
inline constexpr double rate = 1000;
inline const Problem stiff{generic([](const auto& x, auto& dxdt, auto t) {
                             using std::cos, std::sin;
                             dxdt = {-rate * (x[0] - cos(t)) - sin(t), -x[1]};
                           }),
                           [](double t) -> State {
                             return {std::cos(t), std::exp(-t)};
                           }};

/// q'' = 2 q^3 with q = 1/(1-t): a pole at t = 1.
inline const Problem pole{generic([](const auto& x, auto& dxdt, auto) {
                            dxdt = {x[1], 2 * x[0] * x[0] * x[0]};
                          }),
                          [](double t) -> State {
                            return {1 / (1 - t), 1 / ((1 - t) * (1 - t))};
                          }};

/// Free fall from q = 2.
inline const Problem fall{generic([](const auto& x, auto& dxdt, auto) {
                            dxdt = {x[1], -9.81};
                          }),
                          [](double t) -> State {
                            return {2 - 9.81 * t * t / 2, -9.81 * t};
                          }};

inline double distance(const State& a, const State& b) {
  return std::max(std::abs(a[0] - b[0]), std::abs(a[1] - b[1]));
}

}  // namespace problems
