#pragma once

#include <cmath>
#include <vector>

#include "chapters/03_rigid_body_motion/07_bead_on_cubic/models.hpp"
#include "chapters/scene.hpp"
#include "solvers/ode/events.hpp"

/// Shared by the files of exercise 3.7.
namespace oddity::ex03_07 {

/// An upper bound of the arrival: at rest the bead's metric is largest, and int_0^1 ds / std::sqrt(1 - s^3) =
/// 1.402.
inline double latest(const bead_on_cubic::Given<double>& bead) {
  return 1.5 * std::sqrt(bead_on_cubic::metric(bead.q0) / (2 * bead.g * bead.q0));
}

/// Time and state at which a model arrives at the origin.
template <class Algorithm, class Model>
Solved<ode::Happened<typename Model::State>> event_of(const Model& model, double setting) {
  return ode::first_event<Algorithm>(bead_on_cubic::ToTheOrigin<Model>{model}, model.start(), 0,
                                     latest(model.p), setting);
}

// methods.cpp
Quantity arrival(const bead_on_cubic::Given<double>&, const Reference&);
Quantity slide(const bead_on_cubic::Given<double>&, const Horizon&, const Reference&);

// claims.cpp
std::vector<Claim> claims(double seed, const Reference&);
Provables proofs();
std::vector<Root> roots();

}  // namespace oddity::ex03_07
