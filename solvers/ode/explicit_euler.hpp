#pragma once

#include <boost/numeric/odeint/stepper/euler.hpp>
#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/integrate_inlined.hpp"

namespace oddity::ode {

/// Order 1, one evaluation per step. Stable on the negative real axis to h |lambda| = 2. Not stable on the
/// imaginary axis: every undamped oscillation grows.
struct ExplicitEuler {
  static constexpr std::string_view name = "explicit Euler";
  static constexpr Kind kind = Kind::fixed;
  static constexpr int order = 1;
  static constexpr Facts facts{.library = Facts::odeint,
                               .in_float = true,
                               .evaluations = 1,
                               .real_limit = 2,
                               .imaginary_limit = 0,
                               .theory = "R(z) = 1 + z"};
  template <class State>
  static auto stepper() {
    using Number = typename State::value_type;
    return boost::numeric::odeint::euler<State, Number, State, Number>();
  }
};

}  // namespace oddity::ode
