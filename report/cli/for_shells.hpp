#pragma once

#include <CLI/CLI.hpp>
#include <string>

/// Files installed with the program, made from its table of verbs and options.
namespace oddity {

/// A bash script that completes verbs, options and exercises without running the program.
std::string completion_of(const CLI::App&);

/// The manual page, in troff, without paths of this build.
std::string manual_of(const CLI::App&, const std::string& version);

}  // namespace oddity
