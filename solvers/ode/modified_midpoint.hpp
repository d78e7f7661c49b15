#pragma once

#include <boost/numeric/odeint/stepper/modified_midpoint.hpp>
#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/integrate.hpp"

namespace oddity::ode {

/// Gragg's rule, which Bulirsch and Stoer extrapolate: order 2, two substeps and three evaluations per step.
/// Stable to h |lambda| = 3.087 on the negative real axis. Not stable on the imaginary axis: undamped
/// oscillations grow slowly, as h^6.
struct ModifiedMidpoint {
  static constexpr std::string_view name = "modified midpoint";
  static constexpr Kind kind = Kind::fixed;
  static constexpr int order = 2;
  static constexpr Facts facts{.library = Facts::odeint,
                               .in_float = true,
                               .evaluations = 3,
                               .real_limit = 3.087378,
                               .imaginary_limit = 0,
                               .theory = "R(z) = 1 + z + z^2/2 + z^3/8, of two substeps"};
  static constexpr unsigned short substeps = 2;
  template <class State>
  static auto stepper() {
    using Number = typename State::value_type;
    return boost::numeric::odeint::modified_midpoint<State, Number, State, Number>(substeps);
  }
};

}  // namespace oddity::ode
