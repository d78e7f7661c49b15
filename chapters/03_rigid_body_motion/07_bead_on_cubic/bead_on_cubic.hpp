#pragma once

#include <cmath>
#include <vector>

#include "chapters/03_rigid_body_motion/07_bead_on_cubic/models.hpp"
#include "chapters/scene.hpp"
#include "solvers/ode/events.hpp"

/// What the files of exercise 3.7 share.
namespace oddity::ex03_07 {

/// Longer than any arrival takes: at rest the bead is heaviest, and int_0^1 ds / std::sqrt(1 - s^3) = 1.402.
inline double latest(const bead_on_cubic::Given<double>& bead) {
  return 1.5 * std::sqrt(bead_on_cubic::metric(bead.q0) / (2 * bead.g * bead.q0));
}

/// The time at which a model's x changes its sign, and the state there.
template <class Algorithm, class Model>
Solved<ode::Event<typename Model::State>> event_of(const Model& model, double setting) {
  const auto x = [&](const typename Model::State& s, double t) { return model.observe(s, t)[0]; };
  return ode::find_event<Algorithm>(model, model.start(), 0, latest(model.p), setting, x);
}

// methods.cpp
Quantity arrival(const bead_on_cubic::Given<double>&, const Reference&);
Quantity slide(const bead_on_cubic::Given<double>&, const Horizon&, const Reference&);

// claims.cpp
std::vector<Claim> claims(double seed, const Reference&);
std::vector<Root> roots();

}  // namespace oddity::ex03_07
