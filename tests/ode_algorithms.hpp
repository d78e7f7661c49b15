#pragma once

#include "solvers/ode/all.hpp"
#include "tests/ode_problems.hpp"

/// Properties of an algorithm's type that the certificates need.
namespace oddity::ode {

/// Has a method of fixed order behind its step control.
template <class Algorithm>
concept HasPlain = requires {
  typename Algorithm::template Plain<problems::State>;
};

template <class Algorithm>
constexpr bool partitioned = Algorithm::kind == Kind::partitioned;

/// Solves systems of the form (q, v) with q' = v.
template <class Algorithm>
constexpr bool of_positions_and_velocities =
    partitioned<Algorithm> || Algorithm::kind == Kind::velocities_first;

/// The states after each of n steps of equal size, the start first.
template <class Algorithm>
std::vector<problems::State> fixed_steps(const problems::System& system, problems::State x, double t0,
                                         double t1, int n) {
  const double h = (t1 - t0) / n;
  std::vector<problems::State> states{x};
  if constexpr (HasPlain<Algorithm>) {
    typename Algorithm::template Plain<problems::State> stepper;
    for (int i = 0; i < n; ++i) {
      stepper.do_step(system, x, t0 + i * h, h);
      states.push_back(x);
    }
  } else {
    std::vector<double> times;
    for (int i = 0; i <= n; ++i) times.push_back(t0 + i * h);
    states = integrate<Algorithm>(system, x, std::span<const double>(times), std::abs(h)).value;
  }
  return states;
}

/// Its steps and their errors depend on previous steps.
template <class Algorithm>
constexpr bool multistep = requires {
  Algorithm::recurrence(0.0);
};

/// Begins with low order and few digits, and the early errors stay in the rest of the motion.
template <class Algorithm>
constexpr bool changes_order =
    Algorithm::kind == Kind::self_stepping && !HasPlain<Algorithm> && !std::is_same_v<Algorithm, Taylor>;

/// A setting that solves the problems of this folder well: a small step, or a small tolerance.
template <class Algorithm>
constexpr double fine = has_tolerance(Algorithm::kind) ? 1e-9 : 1e-3;

}  // namespace oddity::ode
