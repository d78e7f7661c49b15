#pragma once

#include <cmath>

#include "report/plain/halves.hpp"

namespace oddity::plain {

/// McLachlan's symmetric composition of five drifts and four kicks: order 4, four evaluations of the forces
/// per step.
template <class Model>
struct McLachlan4 {
  using State = typename Model::State;
  using Number = typename State::value_type;

  void step(const Model& model, State& x, Number, Number h) {
    using std::sqrt;
    static const Number half = Number(1) / 2, third = Number(1) / 3, z = sqrt(Number(7) / 8) / 3;
    static const Number drifts[] = {half - z, -third + z, 2 * third, -third + z, half - z};
    static const Number kicks[] = {1, -half, -half, 1};
    Halves<State> halves(x);
    auto& [q, v] = halves;
    typename Halves<State>::Half a{};
    for (std::size_t stage = 0; stage < 5; ++stage) {
      for (std::size_t i = 0; i < q.size(); ++i) q[i] += drifts[stage] * h * v[i];
      if (stage == 4) break;
      model.acceleration(q, a);
      for (std::size_t i = 0; i < q.size(); ++i) v[i] += kicks[stage] * h * a[i];
    }
    halves.put(x);
  }
};

}  // namespace oddity::plain
