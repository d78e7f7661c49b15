#pragma once

#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <string_view>

#include "solvers/ode/integrate.hpp"

namespace oddity::ode {

/// Extrapolation of the modified midpoint rule with controlled step and order.
struct BulirschStoer {
  static constexpr std::string_view name = "Bulirsch-Stoer";
  static constexpr Kind kind = Kind::controlled;
  static constexpr double first_step = 1e-2;  ///< of the whole span
  static constexpr auto success = boost::numeric::odeint::success;
  template <class State>
  static auto stepper(double tolerance) {
    return boost::numeric::odeint::bulirsch_stoer<State>(tolerance, tolerance);
  }
};

}  // namespace oddity::ode
