#pragma once

#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/integrate.hpp"

namespace oddity::ode {

namespace detail {

/// Odeint weighs its orders by cost over the signed step, and so picks the most expensive one when time runs
/// backward. Here time itself is reversed instead.
template <class State>
struct BulirschStoerEitherWay {
  boost::numeric::odeint::bulirsch_stoer<State> forward;

  template <class System>
  auto try_step(const System& system, State& x, double& t, double& h) {
    const double sign = h > 0 ? 1 : -1;
    const auto forth = [&system, sign](const State& y, State& dydt, double s) {
      system(y, dydt, sign * s);
      for (double& component : dydt) component *= sign;
    };
    t *= sign, h *= sign;
    const auto result = forward.try_step(forth, x, t, h);
    t *= sign, h *= sign;
    return result;
  }
};

}  // namespace detail

/// Extrapolation of the modified midpoint rule with controlled step size and order.
struct BulirschStoer {
  static constexpr std::string_view name = "Bulirsch-Stoer";
  static constexpr Kind kind = Kind::controlled;
  static constexpr Facts facts{.library = Facts::odeint};
  static constexpr double first_step = 1e-2;  ///< fraction of the whole span
  static constexpr auto success = boost::numeric::odeint::success;
  template <class State>
  static auto stepper(double tolerance) {
    return detail::BulirschStoerEitherWay<State>{{tolerance, tolerance}};
  }
};

}  // namespace oddity::ode
