#pragma once

#include <filesystem>
#include <vector>

#include "extras/mutation/schemata.hpp"

namespace oddity::mutation {

struct Folders {
  std::filesystem::path tree;    ///< the mutated copy
  std::filesystem::path build;   ///< where it is compiled
  std::filesystem::path beside;  ///< the build of the tree, which provides everything else
};

/// Compiles the sources of the mutants' rooms and the tests that include their headers, and links the program
/// and the tests again. The new objects come first, so that their copies win over those of the existing
/// build. Functions that other rooms have inlined are not mutated. Returns the program. Throws BadInput if a
/// step fails.
std::filesystem::path compiled_program(const Folders&, const std::vector<Mutant>&);

}  // namespace oddity::mutation
