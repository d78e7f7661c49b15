#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "chapters/provable.hpp"
#include "report/study/run.hpp"

/// Checks of provable claims by Coq.
namespace oddity {

/// Coq's answer to a file.
struct Checked {
  std::string claim;
  bool proved = false;
  bool kept = false;    ///< an earlier run proved this very file
  double seconds = 0;   ///< wall time
  std::string message;  ///< the reason, if not proved
};

/// Prefixes of the allowed axioms, as Coq prints them.
std::span<const std::string_view> known_axioms();

/// Reports axioms in the output of `Print Assumptions` that proofs about real numbers do not need. Allowed
/// are those of Coq's reals, of classical logic, and of the specification of the processor's integers and
/// doubles. An admitted statement is reported as well.
std::vector<std::string> unknown_axioms(const std::string& printed);

/// Coq's compiler and the libraries that the proofs need; false if one is missing.
bool coq_is_there();

/// Writes the files into the folder, CLAIM.v each, and checks those with coqc that were not proved before.
std::vector<Checked> prove(const Provables&, const std::filesystem::path& folder, const Progress&);
/// Only writes them.
void write_proofs(const Provables&, const std::filesystem::path& folder);

}  // namespace oddity
