#pragma once

#include <filesystem>
#include <vector>

#include "extras/mutation/schemata.hpp"

namespace oddity::mutation {

struct Folders {
  std::filesystem::path tree;    ///< the mutated copy
  std::filesystem::path build;   ///< where it is compiled
  std::filesystem::path beside;  ///< the build of the tree, which gives all else
};

/// Compiles the sources of the mutants' rooms, and the tests that include their headers, and links the
/// program and the tests anew, these before all that the build beside has, whose copies come second and are
/// not taken. What other rooms have inlined of their headers is not mutated. Returns the program. Throws
/// BadInput where something fails.
std::filesystem::path compiled_program(const Folders&, const std::vector<Mutant>&);

}  // namespace oddity::mutation
