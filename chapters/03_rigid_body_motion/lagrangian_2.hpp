#pragma once

#include <array>
#include <cstddef>

#include "solvers/dual.hpp"

/// Lagrange's equations of two coordinates q with v = q', the Lagrangian L(q, v) being generic in its number
/// type: every derivative is taken by nested dual numbers.
namespace oddity {

template <class T>
using Two = std::array<T, 2>;
using Pair = Two<double>;

/// d/dt dL/dv - dL/dq along a motion with q' = v, v' = a.
template <class L>
Pair lagrange_left_side(const L& lagrangian, const Pair& q, const Pair& v, const Pair& a) {
  using Along = Dual<double>;
  using Outer = Dual<Along>;
  Pair left{};
  for (std::size_t i = 0; i < 2; ++i) {
    Two<Outer> position, velocity;
    Two<Along> shifted;
    for (std::size_t j = 0; j < 2; ++j) {
      const double here = i == j ? 1 : 0;
      position[j] = Outer(Along(q[j], v[j]));
      velocity[j] = Outer(Along(v[j], a[j]), Along(here));
      shifted[j] = Along(q[j], here);
    }
    left[i] = lagrangian(position, velocity).slope.slope -
              lagrangian(shifted, Two<Along>{Along(v[0]), Along(v[1])}).slope;
  }
  return left;
}

/// v' such that Lagrange's left side is the generalized force.
template <class L>
Pair lagrange_accelerations(const L& lagrangian, const Pair& q, const Pair& v, const Pair& force = {0, 0}) {
  const Pair at_rest = lagrange_left_side(lagrangian, q, v, {0, 0});
  const Pair one = lagrange_left_side(lagrangian, q, v, {1, 0});
  const Pair two = lagrange_left_side(lagrangian, q, v, {0, 1});
  const double m11 = one[0] - at_rest[0], m21 = one[1] - at_rest[1];
  const double m12 = two[0] - at_rest[0], m22 = two[1] - at_rest[1];
  const double r1 = force[0] - at_rest[0], r2 = force[1] - at_rest[1];
  const double determinant = m11 * m22 - m12 * m21;
  return {(m22 * r1 - m12 * r2) / determinant, (m11 * r2 - m21 * r1) / determinant};
}

}  // namespace oddity
