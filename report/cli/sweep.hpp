#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace oddity {

/// Adds what `sweep` has for verbs: plan, run, status, merge and draw. `folder` is that of the reference
/// tables, once the command line is read.
void add_sweep_verbs(CLI::App& sweep, const std::string& folder);

}  // namespace oddity
