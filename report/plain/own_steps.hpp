#pragma once

namespace oddity::plain {

/// For a model with a step function.
template <class Model>
struct OwnSteps {
  using State = typename Model::State;
  using Number = typename State::value_type;

  void step(const Model& model, State& x, Number t, Number h) { model.step(model, x, t, h); }
};

}  // namespace oddity::plain
