#pragma once

#include <cstddef>

namespace oddity::plain {

/// Gragg's rule with two substeps: order 2, three evaluations per step.
template <class Model>
struct ModifiedMidpoint {
  using State = typename Model::State;
  using Number = typename State::value_type;

  void step(const Model& model, State& x, Number t, Number h) {
    const Number half = h / 2;
    State middle{}, end{}, k{};
    model(x, k, t);
    for (std::size_t i = 0; i < x.size(); ++i) middle[i] = x[i] + half * k[i];
    model(middle, k, t + half);
    for (std::size_t i = 0; i < x.size(); ++i) end[i] = x[i] + h * k[i];
    model(end, k, t + half + half);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = middle[i] / 2 + end[i] / 2 + half / 2 * k[i];
  }
};

}  // namespace oddity::plain
