#pragma once

#include "report/plain/halves.hpp"

namespace oddity::plain {

/// Order 2, one evaluation of the forces per step, and one at the start. If you change the state between two
/// steps, set `started` to false.
template <class Model>
struct VelocityVerlet {
  using State = typename Model::State;
  using Number = typename State::value_type;
  typename Halves<State>::Half a{};  ///< acceleration at the last state
  bool started = false;

  void step(const Model& model, State& x, Number, Number h) {
    Halves<State> halves(x);
    auto& [q, v] = halves;
    if (!started) model.acceleration(q, a);
    started = true;
    const Number half = h / 2;
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = q[i] + h * v[i] + half * h * a[i];
    const auto before = a;
    model.acceleration(q, a);
    for (std::size_t i = 0; i < q.size(); ++i) v[i] = v[i] + half * before[i] + half * a[i];
    halves.put(x);
  }
};

}  // namespace oddity::plain
