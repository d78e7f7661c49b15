#pragma once

#include "report/cli/extras.hpp"

namespace oddity {

/// Adds `bench`.
void add_bench(const CommandLine&);

}  // namespace oddity
