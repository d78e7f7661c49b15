#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "reference/reference.hpp"
#include "report/cli/extras.hpp"

namespace oddity {

/// What the suite is asked: Catch2's own arguments, the folder of the tables, and where to keep the results
/// (nowhere when empty).
struct SuiteRequest {
  std::vector<std::string> catch_arguments;
  std::filesystem::path reference_folder;
  std::filesystem::path results_file;
  std::vector<std::filesystem::path> from = {};  ///< results to judge instead of a run's; none: run
  bool approve = false;  ///< bring the records of the selected exercises to agree with the run
};

/// Runs the verification suite; 0 green, 1 red. Throws BadInput.
using Suite = std::function<int(const SuiteRequest&)>;

/// Runs the command line, with the verbs that extras/ add. Returns the exit code: 0 green, 1 a red suite, 2
/// bad input.
int command_line(int argc, char** argv, const Suite&, const Extras&);

}  // namespace oddity
