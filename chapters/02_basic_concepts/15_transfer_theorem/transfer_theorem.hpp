#pragma once

#include <vector>

#include "chapters/02_basic_concepts/shared/bodies.hpp"

/// Exercise 2.15: systems of particles; shared by the files of the exercise.
namespace oddity::transfer_theorem {

using namespace bodies;

struct Particle {
  double m;
  Vector r;
};
using System = std::vector<Particle>;

inline double mass_of(const System& system) {
  double mass = 0;
  for (const Particle& p : system) mass += p.m;
  return mass;
}
inline Vector center_of(const System& system) {
  Vector moment{};
  for (const Particle& p : system) moment = moment + p.m * p.r;
  return 1 / mass_of(system) * moment;
}
inline Six inertia_about(const System& system, const Vector& point) {
  Six sum{};
  for (const Particle& p : system) sum = sum + inertia_of(p.m, p.r - point);
  return sum;
}

Quantity about_origin(const Parameters&, const Reference&);
Quantity about_center(const Parameters&, const Reference&);

std::vector<Claim> claims(double seed);
Provables proofs();

}  // namespace oddity::transfer_theorem
