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

}  // namespace oddity::ode
