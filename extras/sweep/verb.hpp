#pragma once

#include "report/cli/extras.hpp"

namespace oddity {

/// Adds `sweep` with its subcommands: plan, run, status, merge and draw.
void add_sweep(const CommandLine&);

}  // namespace oddity
