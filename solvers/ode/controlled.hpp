#pragma once

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>

namespace oddity::ode::detail {

/// An embedded Runge-Kutta method under Odeint's step control. Does not use make_controlled, which compiles
/// without generation_controlled_runge_kutta.hpp and then takes the relative tolerance for the largest step.
template <class Plain>
auto controlled(double tolerance) {
  using Controlled = boost::numeric::odeint::controlled_runge_kutta<Plain>;
  static const Plain blank;  // static, so zero: compilers reject a copy of unwritten scratch memory
  return Controlled(typename Controlled::error_checker_type(tolerance, tolerance),
                    typename Controlled::step_adjuster_type(), blank);
}

}  // namespace oddity::ode::detail
