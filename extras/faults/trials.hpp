#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "extras/faults/verbs.hpp"

/// One command under faults: no complete file is lost, no half-written one is left, the exit code is right,
/// and the message names the fault.
namespace faults {

/// Number of trials of each random fault, and of writes at which each other fault is tried.
struct Count {
  int random = 20, writes = 20;
};

struct Cell {
  std::string verb, fault;
  int runs = 0;
  std::vector<std::string> broken = {};  ///< a sentence for each run with a failure
};

/// A row of the table. Empty if this program is built without a library that the command needs.
std::vector<Cell> try_faults(const Verb&, const Installed&, const Count&, unsigned seed);

}  // namespace faults
