#pragma once

#include "report/cli/extras.hpp"

namespace oddity {

/// Adds `engines`.
void add_engines(const CommandLine&);
/// Other people's engines for the other verbs.
OtherEngines other_engines();

}  // namespace oddity
