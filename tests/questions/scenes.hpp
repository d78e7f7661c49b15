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

/// An energy that is conserved or has a known change, and its kinetic part.
struct Energy {
  Real whole, kinetic;
};

struct Scene {
  std::string number;
  double horizon;  ///< usual
  std::vector<Norm> norms;
  std::function<Motion(const Parameters&)> motion;
  /// Distance [m] of the observables from their constraint; empty if no observable is constrained.
  std::function<Real(const Parameters&, const Values& seen, Real t)> off = {};
  /// Energy from the observables followed by their rates; empty if they do not determine it.
  std::function<Energy(const Parameters&, const Values& seen)> energy = {};
};

std::span<const Scene> scenes();

}  // namespace questions
