#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "extras/mutation/suite.hpp"

namespace oddity::mutation {

/// A row of survivors.csv: a mutant that no test notices or even runs, and why none has to, or "" where one
/// should.
struct Survivor {
  std::string room, file, change, reason;
};
using Survivors = std::map<std::string, Survivor>;  ///< by id
Survivors read_survivors(const std::filesystem::path& file);

/// Outcomes of mutants in this run and before. Each is written at once, so that an interrupted run can be
/// continued.
class Outcomes {
 public:
  /// Reads the file, if it exists; with `killed_alone` only the killed ones, and the others are forgotten.
  Outcomes(std::filesystem::path file, bool killed_alone);
  const Judgement* of(const Mutant&) const;
  void add(const Mutant&, const Judgement&);

 private:
  void write() const;

  std::filesystem::path file_;
  std::map<std::string, Judgement> all_;
};

/// The approved survivors as this run leaves them. Those killed now, or no longer in its files, are removed;
/// new ones have no reason yet, except near misses.
Survivors updated(Survivors, const std::vector<Mutant>& all, const std::vector<Mutant>& tried,
                  const Outcomes&);
std::string csv_of(const Survivors&);

/// Outcomes of the mutants tried in one room, and when.
struct Score {
  std::string date = {}, commit = {};
  int mutants = 0, free = 0, tried = 0, killed = 0, with_reason = 0, survived = 0;
  /// Counts of a sample as drawn, before any test was improved for it.
  int first_tried = 0, first_killed = 0;
};
using Scores = std::map<std::string, Score>;  ///< by room
/// Scores of the rooms with a mutant tried.
Scores scores_of(const std::vector<Mutant>& all, const std::vector<Mutant>& tried, const Outcomes&,
                 const Survivors&);

/// A room's recorded score after only its survivors were tried again, and `left` remain. Of the others some
/// are killed now, by id, and some no longer exist as the source has changed. Survivors with a new reason are
/// counted as such.
Score after_again(Score score, const std::string& room, const Survivors& before, const Survivors& left,
                  const std::set<std::string>& killed);

/// The rooms in which the tests notice a smaller share of mutants than they first did of the recorded sample,
/// by three standard deviations, and rooms without a record.
std::vector<std::string> noticed_less(const Scores& now, const Scores& on_record);

/// A table to print.
std::string text_of(const Scores&);
/// The recorded scores, and their text in the record.
Scores read_scores(const std::filesystem::path& file);
std::string csv_of(const Scores&);

}  // namespace oddity::mutation
