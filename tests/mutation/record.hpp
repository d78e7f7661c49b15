#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/mutation/suite.hpp"

namespace oddity::mutation {

/// The survivors on record: by name of the mutant, why nothing has to notice it.
using Reasons = std::map<std::string, std::string>;
Reasons read_reasons(const std::filesystem::path& file);

/// What became of mutants in this run and before. Each is written down at once, so that a run that is
/// interrupted goes on where it was.
class Outcomes {
 public:
  /// Of what the file holds, if it is there; those killed alone where `killed_alone`.
  Outcomes(std::filesystem::path file, bool killed_alone);
  const Judgement* of(const Mutant&) const;
  void add(const Mutant&, const Judgement&);

 private:
  std::filesystem::path file_;
  std::map<std::string, Judgement> all_;
};

/// What became of the mutants tried, room by room.
struct Score {
  int mutants = 0, tried = 0, killed = 0, with_reason = 0, survived = 0, not_reached = 0;
};
using Scores = std::map<std::string, Score>;
Scores scores_of(const std::vector<Mutant>& all, const Outcomes&, const Reasons&);

/// A table for people, and the same as CSV with what the run was.
std::string text_of(const Scores&);
std::string csv_of(const Scores&, const std::string& date, const std::string& commit);
/// A row of survivors.csv whose reason is still to be written.
std::string row_of(const Mutant&);

}  // namespace oddity::mutation
