#pragma once

#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/sundials_driver.hpp"

namespace oddity::ode {

/// The default explicit method of SUNDIALS's ARKODE: order 4 with an embedded order 3 for the step control,
/// five evaluations per step. Stable to h |lambda| = 2.785 on the negative real axis and 2.828 on the
/// imaginary axis.
struct ArkodeZonneveld43 : detail::Sundials<detail::SundialsMethod::zonneveld> {
  static constexpr std::string_view name = "ARKODE Zonneveld 4(3)";
  static constexpr int order = 4;
  static constexpr Facts facts{.library = Facts::sundials,
                               .evaluations = 5,
                               .real_limit = 2.785294,
                               .imaginary_limit = 2.828427,
                               .theory = Facts::polynomial};
  /// The method without its step control.
  template <class State>
  using Plain = detail::PlainSundials<State, detail::SundialsMethod::zonneveld>;
};

}  // namespace oddity::ode
