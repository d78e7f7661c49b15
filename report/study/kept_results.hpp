#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>

#include "report/study/run.hpp"

/// Results that are kept from run to run, exercise by exercise: those of an exercise are made again where
/// what they are made from has changed.
namespace oddity {

/// What the results of each exercise are made from, as checksums: the code that was compiled into this
/// program for it, the tables, and its ledger.
using MadeFrom = std::map<Number, std::string>;

/// Of every exercise of this program. The build writes the code's part beside the program
/// (cmake/made_from.cmake); where it has not, the code is the program as a whole.
MadeFrom made_from(const std::filesystem::path& reference_folder);

/// The same of that text of the build; where it lacks an exercise, `program` stands for its code.
MadeFrom made_from(const std::string& of_build, const std::string& program,
                   const std::filesystem::path& reference_folder);

/// The results with a note of what they are made from.
Results noted(Results, const MadeFrom&);

/// Those of the file's results that this program would find again: none of a file that is not there, is
/// damaged, or is of another version, and none of an exercise that came to a failure.
Results kept_results(const std::filesystem::path& file, const MadeFrom&);

/// Makes the results of these tasks, which are in the results already, as far as they have been made.
using MakeResults = std::function<Results(Results, std::span<const Task>)>;

/// The results of the tasks, in their order. Those that are not there, or not whole, are made, all at once.
Results completed(Results, std::span<const Task>, const std::function<bool(const ExerciseResult&)>& is_whole,
                  const MakeResults&);

}  // namespace oddity
