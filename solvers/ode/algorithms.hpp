#pragma once

#include <string_view>

/// The algorithms of this folder: each is a struct in the header named next to it. From these lists CMake
/// makes all.hpp and compiles each algorithm once for every number of unknowns.
///
/// The explicit algorithms that engines use, simplest first.
#define ODDITY_COMMON_ALGORITHMS(F)         \
  F(ExplicitEuler, explicit_euler)          \
  F(SymplecticEuler, symplectic_euler)      \
  F(SemiImplicitEuler, semi_implicit_euler) \
  F(VelocityVerlet, velocity_verlet)        \
  F(RungeKutta4, runge_kutta_4)             \
  F(CashKarp54, cash_karp_54)               \
  F(DormandPrince54, dormand_prince_54)     \
  F(Fehlberg78, fehlberg_78)                \
  F(BulirschStoer, bulirsch_stoer)
/// The rest of the catalog.
#define ODDITY_OTHER_ALGORITHMS(F)                   \
  F(ModifiedMidpoint, modified_midpoint)             \
  F(McLachlan4, mclachlan_4)                         \
  F(AdamsBashforth4, adams_bashforth)                \
  F(AdamsBashforthMoulton6, adams_bashforth_moulton) \
  F(ImplicitEuler, implicit_euler)                   \
  F(Rosenbrock4, rosenbrock_4)                       \
  F(DormandPrince853, dormand_prince_853)            \
  F(Verner98, verner_98)                             \
  F(Rk8pd, rk8pd)                                    \
  F(Msadams, msadams)                                \
  F(Msbdf, msbdf)                                    \
  F(Bsimp, bsimp)                                    \
  F(Taylor, taylor)
/// Algorithms that are built only if CMake has found SUNDIALS.
#define ODDITY_SUNDIALS_ALGORITHMS(F)       \
  F(CvodeAdams, cvode_adams)                \
  F(CvodeBdf, cvode_bdf)                    \
  F(ArkodeZonneveld43, arkode_zonneveld_43) \
  F(ArkodeVerner65, arkode_verner_65)

namespace oddity::ode {

#define ODDITY_DECLARE(Algorithm, header) struct Algorithm;
ODDITY_COMMON_ALGORITHMS(ODDITY_DECLARE)
ODDITY_OTHER_ALGORITHMS(ODDITY_DECLARE)
ODDITY_SUNDIALS_ALGORITHMS(ODDITY_DECLARE)
#undef ODDITY_DECLARE

#ifdef ODDITY_SUNDIALS
inline constexpr bool has_sundials = true;
#else
inline constexpr bool has_sundials = false;
#endif

/// Names of ODDITY_SUNDIALS_ALGORITHMS, for builds without these.
inline constexpr std::string_view optional_algorithms[] = {"CVODE Adams", "CVODE BDF",
                                                           "ARKODE Zonneveld 4(3)", "ARKODE Verner 6(5)"};

#define ODDITY_CALL(Algorithm, header) f.template operator()<Algorithm>();
/// Calls f.template operator()<Algorithm>() for each of ODDITY_COMMON_ALGORITHMS.
template <class F>
void for_each_common_algorithm(const F& f) {
  ODDITY_COMMON_ALGORITHMS(ODDITY_CALL)
}

/// Calls f for each remaining algorithm of this build.
template <class F>
void for_each_other_algorithm(const F& f) {
  ODDITY_OTHER_ALGORITHMS(ODDITY_CALL)
#ifdef ODDITY_SUNDIALS
  ODDITY_SUNDIALS_ALGORITHMS(ODDITY_CALL)
#endif
}
#undef ODDITY_CALL

template <class F>
void for_each_algorithm(const F& f) {
  for_each_common_algorithm(f);
  for_each_other_algorithm(f);
}

}  // namespace oddity::ode
