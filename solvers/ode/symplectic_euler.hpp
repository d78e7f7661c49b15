#pragma once

#include <boost/numeric/odeint/stepper/symplectic_euler.hpp>
#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/partitioned.hpp"

namespace oddity::ode {

/// Order 1, one evaluation of the forces per step: v += h a(q), then q += h v, as in game engines. Stable on
/// the imaginary axis to h |lambda| = 2, where energy oscillates but does not drift. Odeint moves its
/// coordinate first: here that is v, and q is its momentum.
struct SymplecticEuler {
  static constexpr std::string_view name = "symplectic Euler";
  static constexpr Kind kind = Kind::partitioned;
  static constexpr int order = 1;
  static constexpr Facts facts{.library = Facts::odeint,
                               .in_float = true,
                               .evaluations = 1,
                               .imaginary_limit = 2,
                               .theory = Facts::trace};
  template <class State, class System>
  static auto stepper(const System& system, long& evaluations) {
    using Half = typename detail::Halves<State>::Half;
    using Number = typename Half::value_type;
    return [&system, &evaluations](State& x, Number t, Number h) {
      const auto force = [&](const Half& q, Half& a) {
        ++evaluations;
        system.acceleration(q, a);
      };
      const auto velocity = [](const Half& v, Half& rate) { rate = v; };
      detail::Halves<State> halves(x);
      boost::numeric::odeint::symplectic_euler<Half, Half, Number>().do_step(
          std::pair(force, velocity), std::pair(std::ref(halves.v), std::ref(halves.q)), t, h);
      halves.put(x);
    };
  }
};

}  // namespace oddity::ode
