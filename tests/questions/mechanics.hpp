#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "tests/questions/jet.hpp"

/// Equations of motion from masses, potentials and constraints.
namespace questions {

using Values = std::vector<Real>;

/// A motion to be integrated: q'' = acceleration(q, q', t). Without coordinates it is only observed at a
/// time.
struct Motion {
  Values q, v;  ///< at the start
  std::function<void(const Real* q, const Real* v, Real t, Real* a)> acceleration;
  std::function<Values(const Real* q, Real t)> observe;
  /// It stays at rest once this holds.
  std::function<bool(const Real* v)> at_rest = [](const Real*) { return false; };
  Real tolerance = 4e-18L;  ///< error of a step, relative to the motion's size
};

/// Inertia: mass times u'^2/2 is its kinetic energy, friction times u' the force against it.
template <class X>
struct Moving {
  Real mass;
  X u;
  Real friction = 0;
};

/// Solves a x = b in place by Gauss's elimination with pivots; a has rows of m numbers.
template <std::size_t m>
void solve(std::array<std::array<Real, m>, m>& a, std::array<Real, m>& b) {
  for (std::size_t k = 0; k < m; ++k) {
    std::size_t best = k;
    for (std::size_t i = k + 1; i < m; ++i)
      if (std::abs(a[i][k]) > std::abs(a[best][k])) best = i;
    std::swap(a[k], a[best]);
    std::swap(b[k], b[best]);
    for (std::size_t i = k + 1; i < m; ++i) {
      const Real factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < m; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = m; k-- > 0;) {
    for (std::size_t j = k + 1; j < m; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
}

/// Lagrange's equations of a System. It has n coordinates q and these functions, each a template in its
/// number:
///   moving(q, t)    array of Moving; the kinetic energy is the sum of mass u'^2/2.
///   potential(q, t)
///   held(q, t)      array of `constraints` quantities that stay zero, if any.
///   push(q, v, t)   generalized forces without a potential, if any, in Real.
/// With every u = u(q, t), u' and u'' follow from u's derivatives. D'Alembert's principle is then
///   sum over u of m u_q u'' = -V_q - sum of friction u_q u' + push + held_q^T lambda,  held'' = 0.
template <class System>
void accelerate(const System& system, const Real* q, const Real* v, Real t, Real* a) {
  constexpr std::size_t n = System::n, c = System::constraints, m = n + c;
  using X = Jet<n + 1>;
  std::array<X, n> x;
  for (std::size_t i = 0; i < n; ++i) x[i] = X::variable(q[i], i);
  const X time = X::variable(t, n);
  std::array<Real, n + 1> rate;
  std::copy(v, v + n, rate.begin());
  rate[n] = 1;
  const auto first = [&](const X& u) {
    Real sum = 0;
    for (std::size_t i = 0; i <= n; ++i) sum += u.d[i] * rate[i];
    return sum;
  };
  const auto second = [&](const X& u) {  // without the part of q''
    Real sum = 0;
    for (std::size_t i = 0, k = 0; i <= n; ++i)
      for (std::size_t j = 0; j <= i; ++j, ++k) sum += (i == j ? 1 : 2) * u.dd[k] * rate[i] * rate[j];
    return sum;
  };
  std::array<std::array<Real, m>, m> matrix{};
  std::array<Real, m> force{};
  for (const auto& [mass, u, friction] : system.moving(x, time)) {
    const Real against = mass * second(u) + (friction == 0 ? 0 : friction * first(u));
    for (std::size_t i = 0; i < n; ++i) {
      force[i] -= u.d[i] * against;
      for (std::size_t j = 0; j < n; ++j) matrix[i][j] += mass * u.d[i] * u.d[j];
    }
  }
  const X V = system.potential(x, time);
  for (std::size_t i = 0; i < n; ++i) force[i] -= V.d[i];
  if constexpr (requires { system.push(q, v, t); }) {
    const auto push = system.push(q, v, t);
    for (std::size_t i = 0; i < n; ++i) force[i] += push[i];
  }
  if constexpr (c > 0) {
    const auto held = system.held(x, time);
    for (std::size_t k = 0; k < c; ++k) {
      for (std::size_t i = 0; i < n; ++i) matrix[n + k][i] = matrix[i][n + k] = held[k].d[i];
      force[n + k] = -second(held[k]);
    }
  }
  solve(matrix, force);
  std::copy(force.begin(), force.begin() + n, a);
}

template <std::size_t unknowns>
struct Coordinates {
  static constexpr std::size_t n = unknowns, constraints = 0;
};

/// The system's motion from (q, v); observe(q, t) is the system's.
template <class System>
Motion motion_of(const System& system, Values q, Values v) {
  if (q.size() != System::n || v.size() != System::n) throw std::logic_error("a start has n coordinates");
  return {std::move(q), std::move(v),
          [system](const Real* x, const Real* rate, Real t, Real* a) { accelerate(system, x, rate, t, a); },
          [system](const Real* x, Real t) -> Values { return system.observe(x, t); }};
}

}  // namespace questions
