#pragma once

#include <string_view>

#include "solvers/ode/counted_problem.hpp"
#include "solvers/ode/facts.hpp"
#include "solvers/ode/implicit.hpp"

namespace oddity::ode {

/// Order 1, stable for every step on the left half-plane (L-stable). One evaluation and one Jacobian per
/// step: by dual numbers (n evaluations) if the system is Differentiable, else by central differences (2 n).
/// One Newton step solves the step's equation.
struct ImplicitEuler {
  static constexpr std::string_view name = "linearly implicit Euler";
  static constexpr Kind kind = Kind::implicit_fixed;
  static constexpr int order = 1;
  static constexpr Facts facts{.library = Facts::odeint,
                               .evaluations = 1,
                               .jacobian = true,
                               .real_limit = Facts::everywhere,
                               .imaginary_limit = Facts::everywhere,
                               .theory = "R(z) = 1 / (1 - z)"};
  template <class State, class System>
  static auto stepper(const System& system, long& evaluations) {
    return [problem = detail::CountedProblem<System, State>{system, evaluations}](
               State& x, double t, double h) { detail::implicit_euler_step(problem.view(), x.data(), t, h); };
  }
};

}  // namespace oddity::ode
