#pragma once

#include "report/cli/extras.hpp"

namespace oddity {

/// Adds `engines`.
void add_engines(const CommandLine&);
/// Third-party engines for the other commands.
OtherEngines other_engines();

}  // namespace oddity
