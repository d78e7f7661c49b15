#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reference/limits.hpp"
#include "report/study/results.hpp"

/// Updates verdicts.csv, limits.csv, stability_maps.csv and errors.csv to match a run.
namespace oddity {

/// The new text of a file, and the rows in which it differs from the current one.
struct Approval {
  std::filesystem::path file;
  std::string text;
  std::vector<std::string> added, removed;
};

/// One for each of the four files that would change. Exercises from outside the tree have their own files,
/// which may be missing yet. Replaces the rows of the run's exercises and keeps all others, in the order of
/// the exercises' numbers. An exercise that raised, or that has a quantity without a reference, keeps its
/// rows; an unsettled claim gets none. Throws BadInput when a file of the tree cannot be read.
std::vector<Approval> approvals(const Results&, const std::filesystem::path& folder);

/// "+ row" for each row added and "- row" for each row removed, under the name of their file.
std::string text_of(const std::vector<Approval>&);

/// The columns in which a limit differs from the approved one, with the new values: "step 0.7, error nan".
/// Steps may differ by 5 %, errors by a quarter; NaN (the motion did not finish) matches NaN.
std::string difference(const Limit&, const ApprovedLimit&);

}  // namespace oddity
