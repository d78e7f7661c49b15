#pragma once

#include <filesystem>
#include <string>

namespace oddity::verbs {

/// Writes a file of Coq's and a script of PARI's for each statement about the exercise's claims, of all when
/// the number is empty, and has them checked where coqc and gp are installed. 0 when what was checked holds
/// and all is as on record, else 1. `approve`: puts on record what Coq accepted; throws BadInput where it
/// did not run, or not on all.
int prove(const std::filesystem::path& tables, const std::string& exercise, const std::filesystem::path& out,
          bool approve);

}  // namespace oddity::verbs
