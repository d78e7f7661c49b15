#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "chapters/proofs.hpp"

/// Whether the statements of claims are proved: by Coq, and by the record of what it proved.
namespace oddity {

/// Whether a program is there to be run.
bool is_installed(const std::string& program);

/// What became of a file of Coq's.
struct Proved {
  bool ok = false;
  bool kept = false;                      ///< not run again: it was proved before
  std::vector<std::string> assumes = {};  ///< by the names of Coq's axioms and primitives
  std::string why = {};                   ///< not ok: what Coq said
};

/// Has coqc check the text, within five minutes; what passed is kept in `folder` by the
/// checksum of its text. Writes folder/name.v.
Proved prove(const std::filesystem::path& folder, const std::string& name, const std::string& text);

/// Of what a proof may assume, those that it must not: all but the axioms of the reals, classical logic,
/// extensionality of functions, and the machine's integers.
std::vector<std::string> not_allowed(const std::vector<std::string>& assumes);

/// A row of proofs.csv.
struct ProofRow {
  std::string checksum, kind, bound;
};
/// claim and reading -> what was proved. Throws BadInput when the file is missing or broken.
std::map<std::string, ProofRow> read_proofs(const std::filesystem::path& folder);
/// The file with these as rows.
std::string proofs_csv(const std::vector<Proof>& proofs);
/// How the statements differ from what was proved, a line each; none when they are as on record.
std::vector<std::string> differences(const std::vector<Proof>& proofs,
                                     const std::map<std::string, ProofRow>& record);

}  // namespace oddity
