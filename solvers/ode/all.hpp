#pragma once

#include <string_view>

#include "solvers/ode/adams_bashforth.hpp"
#include "solvers/ode/adams_bashforth_moulton.hpp"
#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/bsimp.hpp"
#include "solvers/ode/bulirsch_stoer.hpp"
#include "solvers/ode/cash_karp_54.hpp"
#include "solvers/ode/dormand_prince_54.hpp"
#include "solvers/ode/explicit_euler.hpp"
#include "solvers/ode/fehlberg_78.hpp"
#include "solvers/ode/implicit_euler.hpp"
#include "solvers/ode/mclachlan_4.hpp"
#include "solvers/ode/modified_midpoint.hpp"
#include "solvers/ode/msadams.hpp"
#include "solvers/ode/msbdf.hpp"
#include "solvers/ode/rk8pd.hpp"
#include "solvers/ode/rosenbrock_4.hpp"
#include "solvers/ode/runge_kutta_4.hpp"
#include "solvers/ode/symplectic_euler.hpp"
#include "solvers/ode/velocity_verlet.hpp"
#ifdef ODDITY_SUNDIALS
#include "solvers/ode/arkode_verner_65.hpp"
#include "solvers/ode/arkode_zonneveld_43.hpp"
#include "solvers/ode/cvode_adams.hpp"
#include "solvers/ode/cvode_bdf.hpp"
#endif

namespace oddity::ode {

/// Calls f.template operator()<Algorithm>() for each of the explicit algorithms that engines use, from the
/// plainest on.
template <class F>
void for_each_common_algorithm(const F& f) {
  f.template operator()<ExplicitEuler>();
  f.template operator()<SymplecticEuler>();
  f.template operator()<VelocityVerlet>();
  f.template operator()<RungeKutta4>();
  f.template operator()<CashKarp54>();
  f.template operator()<DormandPrince54>();
  f.template operator()<Fehlberg78>();
  f.template operator()<BulirschStoer>();
}

/// The rest of the catalog: first those that are compiled into each model, then those behind the seam.
template <class F>
void for_each_other_algorithm(const F& f) {
  f.template operator()<ModifiedMidpoint>();
  f.template operator()<McLachlan4>();
  f.template operator()<AdamsBashforth4>();
  f.template operator()<AdamsBashforthMoulton6>();
  f.template operator()<ImplicitEuler>();
  f.template operator()<Rosenbrock4>();
  f.template operator()<Rk8pd>();
  f.template operator()<Msadams>();
  f.template operator()<Msbdf>();
  f.template operator()<Bsimp>();
#ifdef ODDITY_SUNDIALS
  f.template operator()<CvodeAdams>();
  f.template operator()<CvodeBdf>();
  f.template operator()<ArkodeZonneveld43>();
  f.template operator()<ArkodeVerner65>();
#endif
}

template <class F>
void for_each_algorithm(const F& f) {
  for_each_common_algorithm(f);
  for_each_other_algorithm(f);
}

}  // namespace oddity::ode
