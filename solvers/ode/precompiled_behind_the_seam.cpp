#include "solvers/ode/bsimp.hpp"
#include "solvers/ode/implicit_euler.hpp"
#include "solvers/ode/msadams.hpp"
#include "solvers/ode/msbdf.hpp"
#include "solvers/ode/precompile.hpp"
#include "solvers/ode/rk8pd.hpp"
#include "solvers/ode/rosenbrock_4.hpp"
#ifdef ODDITY_SUNDIALS
#include "solvers/ode/arkode_verner_65.hpp"
#include "solvers/ode/arkode_zonneveld_43.hpp"
#include "solvers/ode/cvode_adams.hpp"
#include "solvers/ode/cvode_bdf.hpp"
#endif

namespace oddity::ode {

ODDITY_PRECOMPILE(ImplicitEuler)
ODDITY_PRECOMPILE(Rosenbrock4)
ODDITY_PRECOMPILE(Rk8pd)
ODDITY_PRECOMPILE(Msadams)
ODDITY_PRECOMPILE(Msbdf)
ODDITY_PRECOMPILE(Bsimp)
#ifdef ODDITY_SUNDIALS
ODDITY_PRECOMPILE(CvodeAdams)
ODDITY_PRECOMPILE(CvodeBdf)
ODDITY_PRECOMPILE(ArkodeZonneveld43)
ODDITY_PRECOMPILE(ArkodeVerner65)
#endif

}  // namespace oddity::ode
