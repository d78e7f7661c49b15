#pragma once

#include <type_traits>

#include "solvers/ode/bulirsch_stoer.hpp"
#include "solvers/ode/cash_karp_54.hpp"
#include "solvers/ode/dormand_prince_54.hpp"
#include "solvers/ode/explicit_euler.hpp"
#include "solvers/ode/fehlberg_78.hpp"
#include "solvers/ode/runge_kutta_4.hpp"
#include "solvers/ode/symplectic_euler.hpp"
#include "solvers/ode/velocity_verlet.hpp"

namespace oddity::ode {

/// Calls f.template operator()<Algorithm>() for every algorithm, from the plainest on.
template <class F>
void for_each_algorithm(const F& f) {
  f.template operator()<ExplicitEuler>();
  f.template operator()<SymplecticEuler>();
  f.template operator()<VelocityVerlet>();
  f.template operator()<RungeKutta4>();
  f.template operator()<CashKarp54>();
  f.template operator()<DormandPrince54>();
  f.template operator()<Fehlberg78>();
  f.template operator()<BulirschStoer>();
}

}  // namespace oddity::ode
