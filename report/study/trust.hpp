#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "reference/ledger.hpp"
#include "report/study/standing.hpp"

/// What is on record of how far the program may be trusted. Records that are not there are empty.
namespace oddity {

/// What bounds the errors of the reference tables.
struct Bounds {
  std::size_t values = 0, enclosed = 0;
  double widest = 0;             ///< error of an enclosed value, over the largest component of its row
  std::set<std::string> agreed;  ///< tables with values that are not
};

/// Errata that PARI/GP was asked about.
struct Witnessed {
  std::set<std::string> at_its_letters;  ///< claims: both sides to ten digits, or what is right alone
  std::set<std::string> at_others;       ///< claims, at letters of the witness's own
  std::set<std::string> words;           ///< claims in which there is nothing to compute
};

/// What was tried at a date and a commit.
struct Tried {
  std::string date, commit, subject;
};
struct Mutated : Tried {  ///< a room
  long mutants = 0, tried = 0, killed = 0, with_reason = 0, survived = 0;
  long first_tried = 0, first_killed = 0;  ///< of the sample as drawn, before anything was mended for it
};
struct Fuzzed : Tried {  ///< a target
  long inputs = 0, crashes = 0;
  double seconds = 0;
};
struct Faulted : Tried {  ///< a verb
  std::string fault;
  long trials = 0, failures = 0;
};

struct Trust {
  Standings standings = {};
  std::vector<Assertion> assertions = {};  ///< of the published solutions, in our words
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
