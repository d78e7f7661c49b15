#include "solvers/ode/adams_bashforth.hpp"
#include "solvers/ode/adams_bashforth_moulton.hpp"
#include "solvers/ode/precompile.hpp"

namespace oddity::ode {

ODDITY_PRECOMPILE(AdamsBashforth4)
ODDITY_PRECOMPILE(AdamsBashforthMoulton6)

}  // namespace oddity::ode
