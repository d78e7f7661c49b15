#pragma once

#include <algorithm>

#include "solvers/ode/any_system.hpp"
#include "solvers/ode/integrate_inlined.hpp"
#include "solvers/ode/jacobian.hpp"
#include "solvers/ode/raw_problem.hpp"

namespace oddity::ode::detail {

/// A system in the form that the libraries take, with its evaluations counted. Refuses evaluations beyond the
/// budget. The Jacobian comes from dual numbers if the system is Differentiable, else from central
/// differences.
template <class System, class State>
struct CountedProblem {
  const System& system;
  long& evaluations;

  static State state(const double* x) {
    State copy{};
    std::copy_n(x, copy.size(), copy.begin());
    return copy;
  }
  static Call rhs(const void* self, const double* x, double* dxdt, double t) {
    const auto& problem = *static_cast<const CountedProblem*>(self);
    if (problem.evaluations > most_evaluations) return Call::budget_spent;
    ++problem.evaluations;
    State derivative{};
    problem.system(state(x), derivative, t);
    std::copy(derivative.begin(), derivative.end(), dxdt);
    return finite(derivative) ? Call::ok : Call::not_finite;
  }
  static Call jacobian(const void* self, const double* x, double* matrix, double* dfdt, double t) {
    const auto& problem = *static_cast<const CountedProblem*>(self);
    const auto counted = [&](long made) {
      problem.evaluations += made;
      return problem.evaluations <= most_evaluations ? Call::ok : Call::budget_spent;
    };
    if constexpr (Differentiable<System, State>)
      return counted(ode::jacobian(problem.system, state(x), matrix, dfdt, t));
    else if constexpr (std::is_base_of_v<AnySystem<std::tuple_size_v<State>>, System>)
      if (problem.system.differentiable()) return counted(problem.system.jacobian(state(x), matrix, dfdt, t));
    return differences(problem.view(), x, matrix, dfdt, t);
  }
  RawProblem view() const { return {std::tuple_size_v<State>, this, &rhs, &jacobian}; }
};

/// A library's driver with the system that it integrates.
template <class Driver, class System, class State>
struct Driven {
  CountedProblem<System, State> problem;
  Driver driver;

  const char* operator()(State& x, double& t, double t1) {
    return driver.advance(problem.view(), x.data(), t, t1);
  }
};

}  // namespace oddity::ode::detail
