#include "solvers/ode/explicit_euler.hpp"
#include "solvers/ode/precompile.hpp"
#include "solvers/ode/runge_kutta_4.hpp"
#include "solvers/ode/symplectic_euler.hpp"
#include "solvers/ode/velocity_verlet.hpp"

namespace oddity::ode {

ODDITY_PRECOMPILE(ExplicitEuler)
ODDITY_PRECOMPILE(SymplecticEuler)
ODDITY_PRECOMPILE(VelocityVerlet)
ODDITY_PRECOMPILE(RungeKutta4)

}  // namespace oddity::ode
