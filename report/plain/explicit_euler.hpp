#pragma once

#include <cstddef>

namespace oddity::plain {

/// Order 1, one evaluation per step.
template <class Model>
struct ExplicitEuler {
  using State = typename Model::State;
  using Number = typename State::value_type;

  void step(const Model& model, State& x, Number t, Number h) {
    State k{};
    model(x, k, t);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += h * k[i];
  }
};

}  // namespace oddity::plain
