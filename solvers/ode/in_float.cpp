#include "solvers/ode/in_float.hpp"

#include <stdexcept>

#include "solvers/ode/adams_bashforth.hpp"
#include "solvers/ode/explicit_euler.hpp"
#include "solvers/ode/mclachlan_4.hpp"
#include "solvers/ode/modified_midpoint.hpp"
#include "solvers/ode/runge_kutta_4.hpp"
#include "solvers/ode/symplectic_euler.hpp"
#include "solvers/ode/velocity_verlet.hpp"

namespace oddity::ode {

namespace {

template <class Algorithm, std::size_t n>
Trajectory<std::array<float, n>> integrate_in_float(const AnySystem<n, float>& system,
                                                    const std::array<float, n>& start,
                                                    std::span<const double> times, double step) {
  if constexpr (Algorithm::kind == Kind::partitioned && n % 2 == 1)
    throw std::logic_error("an odd number of unknowns cannot be partitioned");
  else
    return integrate_inlined<Algorithm>(system, start, times, step);
}

template <std::size_t n, class... Algorithms>
IntegrateInFloat<n>* one_of(std::string_view algorithm) {
  IntegrateInFloat<n>* found = nullptr;
  ((Algorithms::name == algorithm ? void(found = &integrate_in_float<Algorithms, n>) : void()), ...);
  return found;
}

}  // namespace

template <std::size_t n>
IntegrateInFloat<n>* in_float(std::string_view algorithm) {
  return one_of<n, ExplicitEuler, SymplecticEuler, VelocityVerlet, RungeKutta4, ModifiedMidpoint, McLachlan4,
                AdamsBashforth4>(algorithm);
}

#define ODDITY_IN_FLOAT(n, type) template type<n>* in_float<n>(std::string_view);
ODDITY_FOR_UNKNOWNS(ODDITY_IN_FLOAT, IntegrateInFloat)

}  // namespace oddity::ode
