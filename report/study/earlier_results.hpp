#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/study/results.hpp"

/// Results that an earlier run has left in a file: taken where this run would find the same.
namespace oddity {

/// The checksum of the file that runs.
std::string checksum_of_program();
/// The program and the tables that results are made by.
std::string made_by(const std::filesystem::path& reference_folder);

/// What of an exercise's results is not as the suite declares it; empty: nothing.
std::string undeclared(const ExerciseResult&);

/// Throws BadInput, naming the file, when it is not as it was written, or is made by another program or other
/// tables, or of other exercises or parameters than the suite's.
Results earlier_results(const std::filesystem::path& file, const std::string& made_by);
/// The results of these exercises, each from the one file that has it. Throws BadInput, naming it, for one
/// that is in none, or in two.
Results merged_results(const std::vector<std::filesystem::path>& files, const std::vector<Number>&,
                       const std::string& made_by);

}  // namespace oddity
