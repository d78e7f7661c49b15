#pragma once

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <string_view>

#include "solvers/ode/controlled.hpp"
#include "solvers/ode/facts.hpp"
#include "solvers/ode/integrate.hpp"

namespace oddity::ode {

/// Order 8 (propagated by Odeint) with an embedded order 7 for the step control, thirteen evaluations per
/// step. Stable to h |lambda| = 5.008 on the negative real axis and 2.365 on the imaginary axis. The estimate
/// is 41/840 h (k1 + k11 - k12 - k13), whose stages lie at t, t + h, t and t + h: for x' = f(t) it is zero.
struct Fehlberg78 {
  static constexpr std::string_view name = "Fehlberg 7(8)";
  static constexpr Kind kind = Kind::controlled;
  static constexpr int order = 8;
  static constexpr Facts facts{.library = Facts::odeint,
                               .evaluations = 13,
                               .blind_to_time = true,
                               .real_limit = 5.007589,
                               .imaginary_limit = 2.365158,
                               .theory = Facts::polynomial};
  static constexpr double first_step = 1e-3;  ///< fraction of the whole span
  static constexpr auto success = boost::numeric::odeint::success;
  /// The method without its step control.
  template <class State>
  using Plain = boost::numeric::odeint::runge_kutta_fehlberg78<State>;
  template <class State>
  static auto stepper(double tolerance) {
    return detail::controlled<Plain<State>>(tolerance);
  }
};

}  // namespace oddity::ode
