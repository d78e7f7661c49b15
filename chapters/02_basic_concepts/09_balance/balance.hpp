#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "chapters/02_basic_concepts/shared/bodies.hpp"

/// Exercise 2.9: the half disc x^2 + y^2 <= 1, y >= 0 with the density exp(k x); shared by its files.
namespace oddity::balance {

using std::cos, std::sin, std::numbers::pi;

using Moments = std::array<double, 3>;  // mass, and the first moments in x and y

inline Moments moments_of(double density, double x, double y) { return {density, density * x, density * y}; }

/// Columns at x = sin u, of height cos u and width cos u du.
inline Integral by_sine(const Rule& rule, double k, std::size_t which) {
  return nested(
      rule, [=](double u, double y) { return cos(u) * moments_of(std::exp(k * sin(u)), sin(u), y)[which]; },
      -pi / 2, pi / 2, [](double) { return 0.0; }, [](double u) { return cos(u); });
}

inline Integral by_sectors(const Rule& rule, double k, std::size_t which) {
  return nested(
      rule,
      [=](double t, double r) {
        return r * moments_of(std::exp(k * r * cos(t)), r * cos(t), r * sin(t))[which];
      },
      0, pi, [](double) { return 0.0; }, [](double) { return 1.0; });
}

template <class T>
struct ParticleOf {
  T m;
  std::array<T, 3> r;  ///< in the plane z = 0
};
using Particle = ParticleOf<double>;

/// `k` is the exponent of the half disc's density.
std::vector<Claim> claims(double seed, double k);
Provables proofs();
std::vector<Root> roots();

}  // namespace oddity::balance
