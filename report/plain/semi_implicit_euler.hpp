#pragma once

#include <cstddef>

#include "solvers/ode/velocities.hpp"

namespace oddity::plain {

/// Order 1: the velocities first, then the positions with the new velocities. One evaluation per step if the
/// positions' rates are velocities, otherwise two.
template <class Model>
struct SemiImplicitEuler {
  using State = typename Model::State;
  using Number = typename State::value_type;
  ode::Velocities<std::tuple_size_v<State>> velocities;

  void step(const Model& model, State& x, Number t, Number h) {
    if (!velocities.known) velocities = ode::velocities_of<State>(model);
    State rate{};
    model(x, rate, t);
    for (std::size_t i = 0; i < x.size(); ++i)
      if (velocities.is[i]) x[i] += h * rate[i];
    const bool all = velocities.are_all_rates();
    if (!all) model(x, rate, t + h);
    for (std::size_t i = 0; i < x.size(); ++i)
      if (!velocities.is[i]) x[i] += h * (all ? x[velocities.of[i]] : rate[i]);
  }
};

}  // namespace oddity::plain
