#pragma once

#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/gsl_driver.hpp"

namespace oddity::ode {

/// Prince and Dormand's order 8 with an embedded order 7 for the step control, thirteen evaluations per step,
/// the last of which is the next step's first. Stable to h |lambda| = 5.166 on the negative real axis. Not
/// stable on the imaginary axis: undamped oscillations grow slowly, as h^10.
struct Rk8pd : detail::Gsl<detail::GslStep::rk8pd> {
  static constexpr std::string_view name = "GSL rk8pd";
  static constexpr int order = 8;
  static constexpr Facts facts{.library = Facts::gsl,
                               .evaluations = 13,
                               .real_limit = 5.166634,
                               .imaginary_limit = 0,
                               .theory = Facts::polynomial};
  /// The method without its step control.
  template <class State>
  using Plain = detail::PlainGsl<State, detail::GslStep::rk8pd>;
};

}  // namespace oddity::ode
