#pragma once

#include <boost/numeric/odeint/stepper/adams_bashforth.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4_classic.hpp>
#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/integrate.hpp"
#include "solvers/ode/multistep.hpp"

namespace oddity::ode {

/// Order 4, one evaluation per step, after three steps of Runge-Kutta 4: Odeint's default starter has order 1
/// here. A change of step restarts it. Stable to h |lambda| = 0.3 on the negative real axis and 0.430 on the
/// imaginary axis.
struct AdamsBashforth4 {
  static constexpr std::string_view name = "Adams-Bashforth 4";
  static constexpr Kind kind = Kind::fixed;
  static constexpr int order = 4;
  static constexpr Facts facts{.library = Facts::odeint,
                               .in_float = true,
                               .evaluations = 1,
                               .history = true,
                               .real_limit = 0.3,
                               .imaginary_limit = 0.429987,
                               .theory = Facts::characteristic};
  template <class State>
  static auto stepper() {
    namespace odeint = boost::numeric::odeint;
    using Number = typename State::value_type;
    using Algebra = typename odeint::algebra_dispatcher<State>::algebra_type;
    using Operations = typename odeint::operations_dispatcher<State>::operations_type;
    return detail::Restarting<odeint::adams_bashforth<
        order, State, Number, State, Number, Algebra, Operations, odeint::initially_resizer,
        odeint::runge_kutta4_classic<State, Number, State, Number>>>();
  }
  static Recurrence recurrence(std::complex<double> z) {
    Recurrence c;
    for (double b : boost::numeric::odeint::detail::adams_bashforth_coefficients<double, order>())
      c.push_back(z * b);
    c[0] += 1;
    return c;
  }
};

}  // namespace oddity::ode
