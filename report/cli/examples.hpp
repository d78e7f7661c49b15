#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>

namespace oddity {

/// What is meant to fail, or not to be run by tests, of the help's examples; said as beside those of
/// README.md.
struct Mark {
  std::string_view example, says;
};
std::span<const Mark> marks_of_examples();

/// Every example of the help once, a line each: its mark, or "-", a tab, and the command.
std::string examples_of(const CLI::App&);

}  // namespace oddity
