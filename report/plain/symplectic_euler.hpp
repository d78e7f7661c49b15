#pragma once

#include "report/plain/halves.hpp"

namespace oddity::plain {

/// Order 1, one evaluation of the forces per step: v first, then q with the new v.
template <class Model>
struct SymplecticEuler {
  using State = typename Model::State;
  using Number = typename State::value_type;

  void step(const Model& model, State& x, Number, Number h) {
    Halves<State> halves(x);
    auto& [q, v] = halves;
    typename Halves<State>::Half a{};
    model.acceleration(q, a);
    for (std::size_t i = 0; i < q.size(); ++i) v[i] += h * a[i];
    for (std::size_t i = 0; i < q.size(); ++i) q[i] += h * v[i];
    halves.put(x);
  }
};

}  // namespace oddity::plain
