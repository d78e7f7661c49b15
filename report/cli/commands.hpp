#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "reference/reference.hpp"
#include "report/cli/extras.hpp"

namespace oddity {

/// A request to the suite: Catch2's own arguments, the folder of the tables, and the file for the results
/// (empty: not kept).
struct SuiteRequest {
  std::vector<std::string> catch_arguments;
  std::filesystem::path reference_folder;
  std::filesystem::path results_file;
  std::vector<std::filesystem::path> from = {};  ///< results to judge instead of a new run's; empty: run
  bool approve = false;   ///< update the records of the selected exercises to match the run
  bool thorough = false;  ///< look for limits of stability without the records
};

/// Runs the verification suite. Returns 0 if it passes, otherwise 1. Throws BadInput.
using Suite = std::function<int(const SuiteRequest&)>;

/// Runs the command line, with the verbs that extras/ add. Returns the exit code: 0 for success, 1 for a
/// failed suite, 2 for bad input.
int command_line(int argc, char** argv, const Suite&, const Extras&);

}  // namespace oddity
