#pragma once

#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/sundials_driver.hpp"

namespace oddity::ode {

/// Verner's order 6 with an embedded order 5 for the step control, as in SUNDIALS's ARKODE: eight evaluations
/// per step. Stable to h |lambda| = 4.064 on the negative real axis and 1.306 on the imaginary axis. We
/// repair its table (sundials_driver.cpp).
struct ArkodeVerner65 : detail::Sundials<detail::SundialsMethod::verner> {
  static constexpr std::string_view name = "ARKODE Verner 6(5)";
  static constexpr int order = 6;
  static constexpr Facts facts{.library = Facts::sundials,
                               .evaluations = 8,
                               .real_limit = 4.064777,
                               .imaginary_limit = 1.306765,
                               .theory = Facts::polynomial};
  /// The method without its step control.
  template <class State>
  using Plain = detail::PlainSundials<State, detail::SundialsMethod::verner>;
};

}  // namespace oddity::ode
