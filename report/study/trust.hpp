#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "reference/ledger.hpp"
#include "report/study/standing.hpp"

/// Recorded evidence for the program's trustworthiness. Missing records are empty.
namespace oddity {

/// Error bounds of the reference tables.
struct Bounds {
  std::size_t values = 0, enclosed = 0;
  double widest = 0;             ///< error of an enclosed value, over the largest component of its row
  std::set<std::string> agreed;  ///< tables with values that are not enclosed
};

/// Errata checked by PARI/GP.
struct Witnessed {
  std::set<std::string> at_its_letters;  ///< claims: both sides to ten digits, or the right one
  std::set<std::string> at_others;       ///< claims, at other letters
  std::set<std::string> words;           ///< claims without anything to compute
};

/// A test campaign at a date and a commit.
struct Tried {
  std::string date, commit, subject;
};
struct Mutated : Tried {  ///< in a source folder
  long mutants = 0, tried = 0, killed = 0, with_reason = 0, survived = 0;
  long first_tried = 0, first_killed = 0;  ///< in the first sample, before any fixes for it
};
struct Fuzzed : Tried {  ///< for one target
  long inputs = 0, crashes = 0;
  double seconds = 0;
};
struct Faulted : Tried {  ///< for one verb
  std::string fault;
  long trials = 0, failures = 0;
};

struct Trust {
  Standings standings = {};
  std::vector<Assertion> assertions = {};  ///< assertions of the published solutions, in our words
  Bounds bounds = {};
  Witnessed witnessed = {};
  std::vector<Mutated> mutated = {};
  std::vector<Fuzzed> fuzzed = {};
  std::vector<Faulted> faulted = {};
};

/// Reads the records in the folder of the reference tables. Throws BadInput naming file and line when one is
/// broken.
Trust read_trust(const std::filesystem::path& reference);

}  // namespace oddity
