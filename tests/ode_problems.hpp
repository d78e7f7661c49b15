#pragma once

#include <algorithm>
#include <array>
#include <cmath>

/// Initial value problems with known solutions, all of one type, so that every algorithm is compiled once.
namespace problems {

using State = std::array<double, 2>;

/// A right-hand side by function pointer that counts its calls; as (q, v) it is also a partitioned system.
struct System {
  void (*f)(const State& x, State& dxdt, double t);
  mutable long calls = 0;

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

struct Problem {
  System system;
  State (*exact)(double t);
};

/// theta'' = -sin(theta) on its way between its two unstable equilibria: theta = 2 asin(tanh t).
inline const Problem separatrix{{[](const State& x, State& dxdt, double) {
                                  dxdt = {x[1], -std::sin(x[0])};
                                }},
                                [](double t) -> State {
                                  return {2 * std::asin(std::tanh(t)), 2 / std::cosh(t)};
                                }};

inline const Problem oscillator{{[](const State& x, State& dxdt, double) {
                                  dxdt = {x[1], -x[0]};
                                }},
                                [](double t) -> State {
                                  return {std::cos(t), -std::sin(t)};
                                }};

inline const Problem decay{{[](const State& x, State& dxdt, double) {
                             dxdt = {-x[0], -x[1]};
                           }},
                           [](double t) -> State {
                             return {std::exp(-t), std::exp(-t)};
                           }};

/// Two equations with explicit time.
inline const Problem driven{{[](const State& x, State& dxdt, double t) {
                              dxdt = {x[0] * std::cos(t), -x[1] * std::sin(t)};
                            }},
                            [](double t) -> State {
                              return {std::exp(std::sin(t)), std::exp(std::cos(t))};
                            }};

/// Prothero and Robinson's problem, mildly stiff: the solution cos t attracts at the rate 1000.
inline constexpr double rate = 1000;
inline const Problem stiff{{[](const State& x, State& dxdt, double t) {
                             dxdt = {-rate * (x[0] - std::cos(t)) - std::sin(t), -x[1]};
                           }},
                           [](double t) -> State {
                             return {std::cos(t), std::exp(-t)};
                           }};

/// q'' = 2 q^3 with q = 1/(1-t): a pole at t = 1.
inline const Problem pole{{[](const State& x, State& dxdt, double) {
                            dxdt = {x[1], 2 * x[0] * x[0] * x[0]};
                          }},
                          [](double t) -> State {
                            return {1 / (1 - t), 1 / ((1 - t) * (1 - t))};
                          }};

/// Free fall from q = 2.
inline const Problem fall{{[](const State& x, State& dxdt, double) {
                            dxdt = {x[1], -9.81};
                          }},
                          [](double t) -> State {
                            return {2 - 9.81 * t * t / 2, -9.81 * t};
                          }};

inline double distance(const State& a, const State& b) {
  return std::max(std::abs(a[0] - b[0]), std::abs(a[1] - b[1]));
}

}  // namespace problems
