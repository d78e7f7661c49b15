#pragma once

#include <string_view>

#include "solvers/ode/counted_problem.hpp"
#include "solvers/ode/facts.hpp"
#include "solvers/ode/implicit.hpp"

namespace oddity::ode {

/// Order 4 with an embedded order 3 for the step control (Kaps-Rentrop's form, as in Odeint), L-stable: for
/// stiff problems. Per step, six evaluations, a Jacobian and the time derivative: by dual numbers (n + 1
/// evaluations) if the system is Differentiable, else by central differences (2 n + 2).
struct Rosenbrock4 {
  static constexpr std::string_view name = "Rosenbrock 4";
  static constexpr Kind kind = Kind::implicit_controlled;
  static constexpr int order = 4;
  static constexpr Facts facts{.library = Facts::odeint, .evaluations = 6, .jacobian = true};
  static constexpr double first_step = 1e-3;  ///< fraction of the whole span
  template <class State, class System>
  static auto stepper(const System& system, long& evaluations, double tolerance) {
    return [problem = detail::CountedProblem<System, State>{system, evaluations},
            stepper = detail::Rosenbrock(std::tuple_size_v<State>, tolerance)](State& x, double& t,
                                                                               double& h) mutable {
      return stepper.try_step(problem.view(), x.data(), t, h);
    };
  }
};

}  // namespace oddity::ode
