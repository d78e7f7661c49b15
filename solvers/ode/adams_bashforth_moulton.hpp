#pragma once

#include <boost/numeric/odeint/stepper/adams_bashforth_moulton.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/integrate.hpp"
#include "solvers/ode/multistep.hpp"

namespace oddity::ode {

namespace detail {

template <int steps>
struct AdamsBashforthMoulton {
  static constexpr Kind kind = Kind::fixed;
  static constexpr int order = steps;
  /// Odeint's own starter is Runge-Kutta 4. Its few steps leave an error of order 5 on the whole motion.
  template <class State, class Starter = boost::numeric::odeint::runge_kutta_fehlberg78<State>>
  static auto stepper() {
    namespace odeint = boost::numeric::odeint;
    using Algebra = typename odeint::algebra_dispatcher<State>::algebra_type;
    using Operations = typename odeint::operations_dispatcher<State>::operations_type;
    return Restarting<odeint::adams_bashforth_moulton<steps, State, double, State, double, Algebra,
                                                      Operations, odeint::initially_resizer, Starter>>();
  }
  static Recurrence recurrence(std::complex<double> z) {
    namespace odeint = boost::numeric::odeint::detail;
    const odeint::adams_bashforth_coefficients<double, steps> predictor;
    const odeint::adams_moulton_coefficients<double, steps> corrector;
    Recurrence c(steps);
    for (std::size_t j = 0; j < steps; ++j) c[j] = corrector[0] * z * z * predictor[j];
    for (std::size_t j = 0; j + 1 < steps; ++j) c[j] += z * corrector[j + 1];
    c[0] += 1.0 + z * corrector[0];
    return c;
  }
};

}  // namespace detail

/// Adams-Bashforth predicts, Adams-Moulton corrects once, and the derivative is evaluated again (PECE): order
/// 6, two evaluations per step, after five steps of Fehlberg 7(8). A change of step restarts it. Stable to h
/// |lambda| = 0.698 on the negative real axis and 0.526 on the imaginary axis.
struct AdamsBashforthMoulton6 : detail::AdamsBashforthMoulton<6> {
  static constexpr std::string_view name = "Adams-Bashforth-Moulton 6";
  static constexpr Facts facts{.library = Facts::odeint,
                               .evaluations = 2,
                               .history = true,
                               .real_limit = 0.698003,
                               .imaginary_limit = 0.526717,
                               .theory = Facts::characteristic};
};

}  // namespace oddity::ode
