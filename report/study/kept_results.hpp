#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>

#include "report/study/run.hpp"

/// Results kept from run to run, exercise by exercise. Those of an exercise are computed again when their
/// inputs change.
namespace oddity {

/// Checksums of the inputs of each exercise's results: the code compiled into this program for it, the
/// tables, and its ledger.
using MadeFrom = std::map<Number, std::string>;

/// Covers every exercise of this program. The build writes the code's part next to the program
/// (cmake/made_from.cmake); without it, the whole program counts as the code.
MadeFrom made_from(const std::filesystem::path& reference_folder);

/// As above, from the build's text; for an exercise missing there, `program` is used as its code.
MadeFrom made_from(const std::string& of_build, const std::string& program,
                   const std::filesystem::path& reference_folder);

/// The results with a note of their inputs.
Results noted(Results, const MadeFrom&);

/// The results in the file that this program would find again. None from a file that is missing, damaged, or
/// of another version, and none of an exercise that failed.
Results kept_results(const std::filesystem::path& file, const MadeFrom&);

/// Makes the results of these tasks; the given results contain the parts made so far.
using MakeResults = std::function<Results(Results, std::span<const Task>)>;

/// The results of the tasks, in their order. Makes those that are missing or not whole in one call.
Results completed(Results, std::span<const Task>, const std::function<bool(const ExerciseResult&)>& is_whole,
                  const MakeResults&);

}  // namespace oddity
