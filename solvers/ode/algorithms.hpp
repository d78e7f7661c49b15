#pragma once

#include <string_view>

/// The algorithms of this folder by their types, each declared in the header of its name.
namespace oddity::ode {

struct ExplicitEuler;
struct SymplecticEuler;
struct VelocityVerlet;
struct RungeKutta4;
struct CashKarp54;
struct DormandPrince54;
struct Fehlberg78;
struct BulirschStoer;
struct ModifiedMidpoint;
struct McLachlan4;
struct AdamsBashforth4;
struct AdamsBashforthMoulton6;
struct ImplicitEuler;
struct Rosenbrock4;
struct Rk8pd;
struct Msadams;
struct Msbdf;
struct Bsimp;
#ifdef ODDITY_SUNDIALS
struct CvodeAdams;
struct CvodeBdf;
struct ArkodeZonneveld43;
struct ArkodeVerner65;
#endif

#ifdef ODDITY_SUNDIALS
inline constexpr bool has_sundials = true;
#else
inline constexpr bool has_sundials = false;
#endif

/// Those that are in the catalog only where CMake found SUNDIALS.
inline constexpr std::string_view optional_algorithms[] = {"CVODE Adams", "CVODE BDF",
                                                           "ARKODE Zonneveld 4(3)", "ARKODE Verner 6(5)"};

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

/// The rest of the catalog: first the templates, then those behind the seam.
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
