#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/study/results.hpp"

/// Results that an earlier run left in a file, used where this run would compute the same.
namespace oddity {

/// The checksum of the running program's file.
std::string checksum_of_program();
/// The program and the tables that results are made with.
std::string made_by(const std::filesystem::path& reference_folder);

/// The part of an exercise's results that differs from the suite's declarations; empty: none.
std::string undeclared(const ExerciseResult&);

/// Throws BadInput, naming the file, if it was damaged, was made with another program or other tables, or has
/// other exercises or parameters than the suite.
Results earlier_results(const std::filesystem::path& file, const std::string& made_by);
/// The results of these exercises, each from the one file that contains it. Throws BadInput, naming it, for
/// one that is in none or in two.
Results merged_results(const std::vector<std::filesystem::path>& files, const std::vector<Number>&,
                       const std::string& made_by);

}  // namespace oddity
