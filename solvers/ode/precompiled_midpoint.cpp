#include "solvers/ode/bulirsch_stoer.hpp"
#include "solvers/ode/mclachlan_4.hpp"
#include "solvers/ode/modified_midpoint.hpp"
#include "solvers/ode/precompile.hpp"

namespace oddity::ode {

ODDITY_PRECOMPILE(ModifiedMidpoint)
ODDITY_PRECOMPILE(BulirschStoer)
ODDITY_PRECOMPILE(McLachlan4)

}  // namespace oddity::ode
