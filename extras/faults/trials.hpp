#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "extras/faults/verbs.hpp"

/// One verb under faults: nothing that was whole is lost, nothing half-written is left, the exit code is
/// right, and the message says what is wrong.
namespace faults {

/// How often each fault of a kind that is left to chance is tried, and at how many of its writes one that is
/// not.
struct Count {
  int random = 20, writes = 20;
};

struct Cell {
  std::string verb, fault;
  int runs = 0;
  std::vector<std::string> broken = {};  ///< a sentence for each run of which something does not hold
};

/// A row of the table. Empty where this program lacks what the verb needs.
std::vector<Cell> try_faults(const Verb&, const Installed&, const Count&, unsigned seed);

}  // namespace faults
