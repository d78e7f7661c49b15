#pragma once

#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <string_view>

#include "solvers/ode/controlled.hpp"
#include "solvers/ode/facts.hpp"
#include "solvers/ode/integrate.hpp"

namespace oddity::ode {

/// Order 5 with an embedded order 4 for the step control, seven evaluations per step, the last of which is
/// the next step's first. Stable to h |lambda| = 3.307 on the negative real axis and 0.997 on the imaginary
/// axis.
struct DormandPrince54 {
  static constexpr std::string_view name = "Dormand-Prince 5(4)";
  static constexpr Kind kind = Kind::controlled;
  static constexpr int order = 5;
  static constexpr Facts facts{.library = Facts::odeint,
                               .evaluations = 6,
                               .real_limit = 3.306568,
                               .imaginary_limit = 0.997189,
                               .theory = Facts::polynomial};
  static constexpr double first_step = 1e-3;  ///< fraction of the whole span
  static constexpr auto success = boost::numeric::odeint::success;
  /// The method without its step control.
  template <class State>
  using Plain = boost::numeric::odeint::runge_kutta_dopri5<State>;
  template <class State>
  static auto stepper(double tolerance) {
    return detail::controlled<Plain<State>>(tolerance);
  }
};

}  // namespace oddity::ode
