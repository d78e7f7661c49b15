#pragma once

#include <array>
#include <cstddef>

#include "solvers/dual.hpp"

/// Two degrees of freedom q with v = q'. A function f(q, v) is generic in its number type; its derivatives
/// are taken by dual numbers.
namespace oddity {

template <class T>
using Two = std::array<T, 2>;
using Pair = Two<double>;

template <class T = double>
Two<Dual<T>> toward(const Two<T>& x, std::size_t i) {
  return {Dual<T>(x[0], T(i == 0 ? 1.0 : 0.0)), Dual<T>(x[1], T(i == 1 ? 1.0 : 0.0))};
}
template <class T = double>
Two<Dual<T>> still(const Two<T>& x) {
  return {Dual<T>(x[0], T(0.0)), Dual<T>(x[1], T(0.0))};
}
/// x moving at the rate v.
inline Two<Dual<double>> moving(const Pair& x, const Pair& v) { return {{{x[0], v[0]}, {x[1], v[1]}}}; }

template <class F>
Pair df_dq(const F& f, const Pair& q, const Pair& v) {
  return {f(toward(q, 0), still(v)).slope, f(toward(q, 1), still(v)).slope};
}

template <class F>
Pair df_dv(const F& f, const Pair& q, const Pair& v) {
  return {f(still(q), toward(v, 0)).slope, f(still(q), toward(v, 1)).slope};
}

/// d/dt of df/dv along a motion with q' = v, v' = a.
template <class F>
Pair rate_of_df_dv(const F& f, const Pair& q, const Pair& v, const Pair& a) {
  const auto along_q = moving(q, v), along_v = moving(v, a);
  return {f(still(along_q), toward(along_v, 0)).slope.slope,
          f(still(along_q), toward(along_v, 1)).slope.slope};
}

/// d/dt df/dv - df/dq, the left side of Lagrange's equations.
template <class F>
Pair lagrange_left_side(const F& lagrangian, const Pair& q, const Pair& v, const Pair& a) {
  const Pair rate = rate_of_df_dv(lagrangian, q, v, a), slope = df_dq(lagrangian, q, v);
  return {rate[0] - slope[0], rate[1] - slope[1]};
}

/// v' by Lagrange's equations d/dt df/dv = df/dq + force.
template <class F>
Pair lagrange_accelerations(const F& lagrangian, const Pair& q, const Pair& v, const Pair& force = {0, 0}) {
  const auto there = still(still(q));
  const auto mass = [&](std::size_t i, std::size_t j) {
    return lagrangian(there, toward(toward(v, i), j)).slope.slope;
  };
  const Pair dq = df_dq(lagrangian, q, v), rate = rate_of_df_dv(lagrangian, q, v, {0, 0});
  const double m00 = mass(0, 0), m01 = mass(0, 1), m11 = mass(1, 1), b0 = dq[0] + force[0] - rate[0],
               b1 = dq[1] + force[1] - rate[1], determinant = m00 * m11 - m01 * m01;
  return {(m11 * b0 - m01 * b1) / determinant, (m00 * b1 - m01 * b0) / determinant};
}

}  // namespace oddity
