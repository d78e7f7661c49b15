#pragma once

#include <cmath>
#include <span>

#include "chapters/exercise.hpp"

/// Energies of the observed motion, for the laws of scenes.
namespace oddity {

inline Energy energy_seen(double kinetic, double potential) { return {kinetic + potential, kinetic}; }

inline double half_square(std::span<const double> x) {
  double sum = 0;
  for (double one : x) sum += one * one / 2;
  return sum;
}

/// Energy of a unit mass in space with the third coordinate upward, from its position and velocity.
inline Energy point_energy(double g, std::span<const double> x) {
  return energy_seen(half_square(x.subspan(3)), g * x[2]);
}

/// Energy of a unit mass in the plane, attracted with mu/r^2 by a center.
inline Energy orbit_energy(double mu, std::span<const double> x) {
  return energy_seen(half_square(x.subspan(2)), -mu / std::hypot(x[0], x[1]));
}

}  // namespace oddity
