#pragma once

#include <boost/numeric/odeint/stepper/runge_kutta4_classic.hpp>
#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/integrate_inlined.hpp"

namespace oddity::ode {

/// Kutta's classical method: order 4, four evaluations per step. Stable to h |lambda| = 2.785 on the negative
/// real axis and 2.828 on the imaginary axis.
struct RungeKutta4 {
  static constexpr std::string_view name = "Runge-Kutta 4";
  static constexpr Kind kind = Kind::fixed;
  static constexpr int order = 4;
  static constexpr Facts facts{.library = Facts::odeint,
                               .in_float = true,
                               .evaluations = 4,
                               .real_limit = 2.785294,
                               .imaginary_limit = 2.828427,
                               .theory = Facts::polynomial};
  template <class State>
  static auto stepper() {
    using Number = typename State::value_type;
    return boost::numeric::odeint::runge_kutta4_classic<State, Number, State, Number>();
  }
};

}  // namespace oddity::ode
