#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reference/limits.hpp"
#include "report/study/results.hpp"

/// What is on record in verdicts.csv, limits.csv, stability_maps.csv and errors.csv, brought to agree with a
/// run.
namespace oddity {

/// A file as it would be, and the rows by which that differs from what it is.
struct Approval {
  std::filesystem::path file;
  std::string text;
  std::vector<std::string> added, removed;
};

/// One for each of the four files that would change; exercises from outside the tree have files of their
/// own, which need not be there yet. The rows of the run's exercises are replaced, all others stay; exercises
/// are in the order of their numbers. An exercise that raised, or a quantity of which has no reference, keeps
/// its rows; an unsettled claim gets none. Throws BadInput when a file of the tree cannot be read.
std::vector<Approval> approvals(const Results&, const std::filesystem::path& folder);

/// "+ row" for each row added and "- row" for each row removed, under the name of their file.
std::string text_of(const std::vector<Approval>&);

/// The columns in which a limit is not as on record, each with what is there: "step 0.7, error nan". Steps
/// may differ by 5 %, errors by a quarter; one that is no number, as the motion did not come to its end, is
/// like another.
std::string difference(const Limit&, const ApprovedLimit&);

}  // namespace oddity
