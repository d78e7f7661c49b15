#include "solvers/ode/cash_karp_54.hpp"
#include "solvers/ode/dormand_prince_54.hpp"
#include "solvers/ode/fehlberg_78.hpp"
#include "solvers/ode/precompile.hpp"

namespace oddity::ode {

ODDITY_PRECOMPILE(CashKarp54)
ODDITY_PRECOMPILE(DormandPrince54)
ODDITY_PRECOMPILE(Fehlberg78)

}  // namespace oddity::ode
