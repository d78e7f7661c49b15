#pragma once

#include <boost/numeric/odeint/stepper/runge_kutta_cash_karp54.hpp>
#include <string_view>

#include "solvers/ode/controlled.hpp"
#include "solvers/ode/facts.hpp"
#include "solvers/ode/integrate.hpp"

namespace oddity::ode {

/// Order 5 with an embedded order 4 for the step control, six evaluations per step. Stable to h |lambda| =
/// 3.734 on the negative real axis. Not stable on the imaginary axis: undamped oscillations grow slowly, as
/// h^6.
struct CashKarp54 {
  static constexpr std::string_view name = "Cash-Karp 5(4)";
  static constexpr Kind kind = Kind::controlled;
  static constexpr int order = 5;
  static constexpr Facts facts{.library = Facts::odeint,
                               .evaluations = 6,
                               .real_limit = 3.734360,
                               .imaginary_limit = 0,
                               .theory = Facts::polynomial};
  static constexpr double first_step = 1e-3;  ///< fraction of the whole span
  static constexpr auto success = boost::numeric::odeint::success;
  /// The method without its step control.
  template <class State>
  using Plain = boost::numeric::odeint::runge_kutta_cash_karp54<State>;
  template <class State>
  static auto stepper(double tolerance) {
    return detail::controlled<Plain<State>>(tolerance);
  }
};

}  // namespace oddity::ode
