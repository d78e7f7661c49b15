#pragma once

#include <boost/numeric/odeint/stepper/base/symplectic_rkn_stepper_base.hpp>  // missing in the header below
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_m4_mclachlan.hpp>
#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/partitioned.hpp"

namespace oddity::ode {

/// McLachlan's symmetric composition of five drifts and four kicks: order 4, symplectic and reversible, four
/// evaluations of the forces per step. Stable on the imaginary axis to h |lambda| = 2.967.
struct McLachlan4 {
  static constexpr std::string_view name = "McLachlan 4";
  static constexpr Kind kind = Kind::partitioned;
  static constexpr int order = 4;
  static constexpr Facts facts{.library = Facts::odeint,
                               .in_float = true,
                               .evaluations = 4,
                               .imaginary_limit = 2.967808,
                               .theory = Facts::trace};
  template <class State, class System>
  static auto stepper(const System& system, long& evaluations) {
    using Half = typename detail::Halves<State>::Half;
    using Number = typename Half::value_type;
    return [&system, &evaluations](State& x, Number t, Number h) {
      int stage = 0;
      const auto force = [&](const Half& q, Half& a) {
        if (++stage == 5)
          return void(a = {});  // Odeint evaluates once more, and multiplies the result by zero
        ++evaluations;
        system.acceleration(q, a);
      };
      detail::Halves<State> halves(x);
      boost::numeric::odeint::symplectic_rkn_sb3a_m4_mclachlan<Half, Half, Number>().do_step(
          force, std::pair(std::ref(halves.q), std::ref(halves.v)), t, h);
      halves.put(x);
    };
  }
};

}  // namespace oddity::ode
