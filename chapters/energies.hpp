#pragma once

#include <cmath>
#include <span>

#include "chapters/exercise.hpp"

/// Energies of what is seen, of which scenes state theirs.
namespace oddity {

inline Energy energy_seen(double kinetic, double potential) { return {kinetic + potential, kinetic}; }

inline double half_square(std::span<const double> x) {
  double sum = 0;
  for (double one : x) sum += one * one / 2;
  return sum;
}

/// Of a unit mass in space, the third coordinate upward: its place and its velocity.
inline Energy point_energy(double g, std::span<const double> x) {
  return energy_seen(half_square(x.subspan(3)), g * x[2]);
}

/// Of a unit mass in the plane about a center that attracts with mu/r^2.
inline Energy orbit_energy(double mu, std::span<const double> x) {
  return energy_seen(half_square(x.subspan(2)), -mu / std::hypot(x[0], x[1]));
}

}  // namespace oddity
