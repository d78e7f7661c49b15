#pragma once

#include <CLI/CLI.hpp>
#include <string>

/// What is installed beside the program, from the table of its own verbs and options.
namespace oddity {

/// A script for bash that completes verbs, options and exercises, and runs nothing for it.
std::string completion_of(const CLI::App&);

/// The manual page, in troff. Paths of this build are not in it.
std::string manual_of(const CLI::App&, const std::string& version);

}  // namespace oddity
