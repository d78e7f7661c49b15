#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "tests/questions/mechanics.hpp"

namespace questions {

using Parameters = std::map<std::string, Real, std::less<>>;

/// Observables that are one vector; its length is in this unit.
struct Norm {
  std::string unit;
  std::vector<std::size_t> parts;
};

/// What is kept, or changes as it truly does, and the kinetic part of it.
struct Energy {
  Real whole, kinetic;
};

struct Scene {
  std::string number;
  double horizon;  ///< usual
  std::vector<Norm> norms;
  std::function<Motion(const Parameters&)> motion;
  /// How far [m] what is seen is off what holds it; none where nothing seen is held.
  std::function<Real(const Parameters&, const Values& seen, Real t)> off = {};
  /// Of what is seen and its rates, one after the other; none where what is seen does not tell it.
  std::function<Energy(const Parameters&, const Values& seen)> energy = {};
};

std::span<const Scene> scenes();

}  // namespace questions
