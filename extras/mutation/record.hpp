#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "extras/mutation/suite.hpp"

namespace oddity::mutation {

/// A row of survivors.csv: a mutant that nothing notices, be it that nothing runs it, and why nothing has
/// to, or "" where something should.
struct Survivor {
  std::string room, file, change, reason;
};
using Survivors = std::map<std::string, Survivor>;  ///< by id
Survivors read_survivors(const std::filesystem::path& file);

/// What became of mutants in this run and before. Each is written down at once, so that a run that is
/// interrupted goes on where it was.
class Outcomes {
 public:
  /// Of what the file holds, if it is there; those killed alone where `killed_alone`, and others are
  /// forgotten.
  Outcomes(std::filesystem::path file, bool killed_alone);
  const Judgement* of(const Mutant&) const;
  void add(const Mutant&, const Judgement&);

 private:
  void write() const;

  std::filesystem::path file_;
  std::map<std::string, Judgement> all_;
};

/// The survivors on record as this run leaves them: those killed now, or no more in its files, are gone; new
/// ones have no reason yet, save near misses.
Survivors updated(Survivors, const std::vector<Mutant>& all, const std::vector<Mutant>& tried,
                  const Outcomes&);
std::string csv_of(const Survivors&);

/// What became of the mutants tried in one room, and when.
struct Score {
  std::string date = {}, commit = {};
  int mutants = 0, free = 0, tried = 0, killed = 0, with_reason = 0, survived = 0;
  /// Of a sample as it was drawn, before anything was mended for its sake.
  int first_tried = 0, first_killed = 0;
};
using Scores = std::map<std::string, Score>;  ///< by room
/// Of the rooms of which a mutant was tried.
Scores scores_of(const std::vector<Mutant>& all, const std::vector<Mutant>& tried, const Outcomes&,
                 const Survivors&);

/// A room's score on record where its survivors alone were tried again, and these are left: of the others
/// some are killed now, by id, and some are no more as the source has changed; what has no reason any more
/// has been given one.
Score after_again(Score score, const std::string& room, const Survivors& before, const Survivors& left,
                  const std::set<std::string>& killed);

/// The rooms of which the suite notices a smaller share of the mutants than it first did of the sample on
/// record, by three times what such shares vary by; and those that are not on record.
std::vector<std::string> noticed_less(const Scores& now, const Scores& on_record);

/// A table for people.
std::string text_of(const Scores&);
/// The scores on record, and as they are written there.
Scores read_scores(const std::filesystem::path& file);
std::string csv_of(const Scores&);

}  // namespace oddity::mutation
