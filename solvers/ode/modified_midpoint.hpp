#pragma once

#include <boost/numeric/odeint/stepper/modified_midpoint.hpp>
#include <string_view>

#include "solvers/ode/integrate.hpp"

namespace oddity::ode {

/// Gragg's rule, of which Bulirsch and Stoer extrapolate: order 2, two substeps and three evaluations per
/// step. Stable to h |lambda| = 3.087 on the negative real axis, on the imaginary axis nowhere: undamped
/// oscillations grow, slowly, as h^6.
struct ModifiedMidpoint {
  static constexpr std::string_view name = "modified midpoint";
  static constexpr Kind kind = Kind::fixed;
  static constexpr int order = 2;
  static constexpr unsigned short substeps = 2;
  template <class State>
  static auto stepper() {
    using Number = typename State::value_type;
    return boost::numeric::odeint::modified_midpoint<State, Number, State, Number>(substeps);
  }
};

}  // namespace oddity::ode
