#pragma once

#include <cmath>

#include "report/plain/halves.hpp"

namespace oddity::plain {

/// McLachlan's symmetric composition of five drifts and four kicks: order 4, four evaluations of the forces a
/// step.
template <class Model>
struct McLachlan4 {
  using State = typename Model::State;

  void step(const Model& model, State& x, double, double h) {
    static const double z = std::sqrt(7.0 / 8) / 3;
    static const double drifts[] = {1.0 / 2 - z, -1.0 / 3 + z, 2.0 / 3, -1.0 / 3 + z, 1.0 / 2 - z};
    static constexpr double kicks[] = {1, -1.0 / 2, -1.0 / 2, 1};
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
