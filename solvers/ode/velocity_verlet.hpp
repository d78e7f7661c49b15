#pragma once

#include <boost/numeric/odeint/stepper/velocity_verlet.hpp>
#include <memory>
#include <string_view>

#include "solvers/ode/facts.hpp"
#include "solvers/ode/partitioned.hpp"

namespace oddity::ode {

/// Order 2, one evaluation of the forces per step (and one to start). Symplectic and reversible; stable on
/// the imaginary axis to h |lambda| = 2.
struct VelocityVerlet {
  static constexpr std::string_view name = "velocity Verlet";
  static constexpr Kind kind = Kind::partitioned;
  static constexpr int order = 2;
  static constexpr Facts facts{.library = Facts::odeint,
                               .in_float = true,
                               .evaluations = 1,
                               .imaginary_limit = 2,
                               .theory = Facts::trace};
  template <class State, class System>
  static auto stepper(const System& system, long& evaluations) {
    using Half = typename detail::Halves<State>::Half;
    using Number = typename Half::value_type;
    const auto verlet = std::make_shared<boost::numeric::odeint::velocity_verlet<Half, Half, Number>>();
    return [&system, &evaluations, verlet](State& x, Number t, Number h) {
      const auto force = [&](const Half& q, const Half&, Half& a, Number) {
        ++evaluations;
        system.acceleration(q, a);
      };
      detail::Halves<State> halves(x);
      verlet->do_step(force, std::pair(std::ref(halves.q), std::ref(halves.v)), t, h);
      halves.put(x);
    };
  }
};

}  // namespace oddity::ode
