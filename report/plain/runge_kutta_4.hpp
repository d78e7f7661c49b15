#pragma once

#include <cstddef>

namespace oddity::plain {

/// Kutta's classical method: order 4, four evaluations per step.
template <class Model>
struct RungeKutta4 {
  using State = typename Model::State;
  using Number = typename State::value_type;

  void step(const Model& model, State& x, Number t, Number h) {
    State k1{};
    model(x, k1, t);
    step(model, x, k1, t, h);
  }

  /// Takes a step from x, given the derivative k1 there.
  void step(const Model& model, State& x, const State& k1, Number t, Number h) {
    const Number half = h / 2, third = h / 3, sixth = h / 6;
    State y{}, k2{}, k3{}, k4{};
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = x[i] + half * k1[i];
    model(y, k2, t + half);
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = x[i] + half * k2[i];
    model(y, k3, t + half);
    for (std::size_t i = 0; i < x.size(); ++i) y[i] = x[i] + h * k3[i];
    model(y, k4, t + h);
    for (std::size_t i = 0; i < x.size(); ++i)
      x[i] = x[i] + sixth * k1[i] + third * k2[i] + third * k3[i] + sixth * k4[i];
  }
};

}  // namespace oddity::plain
