#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "chapters/provable.hpp"
#include "report/study/run.hpp"

/// Coq's word on what is provable.
namespace oddity {

/// What Coq says to a file.
struct Checked {
  std::string claim;
  bool proved = false;
  bool kept = false;    ///< a run before had proved this very file
  double seconds = 0;   ///< on the clock
  std::string message;  ///< why it is not proved
};

/// These axioms begin so, in the words of Coq.
std::span<const std::string_view> known_axioms();

/// The axioms that proofs about real numbers rest on: of Coq's reals, of classical logic, and those that say
/// that the processor's integers and doubles are as they are specified. Anything else in what `Print
/// Assumptions` prints is named, as is a statement that was admitted.
std::vector<std::string> unknown_axioms(const std::string& printed);

/// Coq's compiler and the libraries that proofs take; false where one is missing.
bool coq_is_there();

/// Writes the files into the folder, CLAIM.v each, and has coqc check those that it has not proved before.
std::vector<Checked> prove(const Provables&, const std::filesystem::path& folder, const Progress&);
/// Only writes them.
void write_proofs(const Provables&, const std::filesystem::path& folder);

}  // namespace oddity
