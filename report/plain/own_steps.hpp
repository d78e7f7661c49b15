#pragma once

namespace oddity::plain {

/// Of a model that takes its steps by itself.
template <class Model>
struct OwnSteps {
  using State = typename Model::State;
  using Number = typename State::value_type;

  void step(const Model& model, State& x, Number t, Number h) { model.step(model, x, t, h); }
};

}  // namespace oddity::plain
