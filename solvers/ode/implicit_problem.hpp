#pragma once

#include <algorithm>

#include "solvers/ode/implicit.hpp"
#include "solvers/ode/integrate.hpp"
#include "solvers/ode/jacobian.hpp"

namespace oddity::ode::detail {

/// A differentiable system as the implicit steppers want it, its evaluations counted.
template <class System, class State>
requires Differentiable<System, State>
struct CountedProblem {
  const System& system;
  long& evaluations;

  static State state(const double* x) {
    State copy{};
    std::copy_n(x, copy.size(), copy.begin());
    return copy;
  }
  static void rhs(const void* self, const double* x, double* dxdt, double t) {
    const auto& problem = *static_cast<const CountedProblem*>(self);
    ++problem.evaluations;
    State derivative{};
    problem.system(state(x), derivative, t);
    std::copy(derivative.begin(), derivative.end(), dxdt);
  }
  static void jacobian(const void* self, const double* x, double* matrix, double* dfdt, double t) {
    const auto& problem = *static_cast<const CountedProblem*>(self);
    problem.evaluations += static_cast<long>(std::tuple_size_v<State>) + 1;
    ode::jacobian(problem.system, state(x), matrix, dfdt, t);
  }
  ImplicitProblem view() const { return {std::tuple_size_v<State>, this, &rhs, &jacobian}; }
};

}  // namespace oddity::ode::detail
