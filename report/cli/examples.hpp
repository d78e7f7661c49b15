#pragma once

#include <CLI/CLI.hpp>
#include <span>
#include <string>

namespace oddity {

/// Marks an example of the help that should fail, or that tests do not run; same words as in README.md.
struct Mark {
  std::string_view example, says;
};
std::span<const Mark> marks_of_examples();

/// Every example of the help once, one per line: its mark or "-", a tab, and the command.
std::string examples_of(const CLI::App&);

}  // namespace oddity
