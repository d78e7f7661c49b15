#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace oddity {

/// What is on record of a claim that Coq has proved.
struct ProvedClaim {
  std::string hash;    ///< of the file that was checked
  std::string proved;  ///< in words
  double margin = 0;   ///< by which the printed value is off at the least; 0 where there is none
};
/// By claim id.
using ProvedClaims = std::map<std::string, ProvedClaim, std::less<>>;

/// Of a file: 64 bits by FNV-1a, the same everywhere.
std::string proof_hash(std::string_view file);

/// Reads proofs.csv in `folder`. Throws BadInput naming file and line when it is missing or broken.
ProvedClaims read_proofs(const std::filesystem::path& folder);
/// Its text.
std::string proofs_csv(const ProvedClaims&);

}  // namespace oddity
