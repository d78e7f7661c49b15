#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace oddity {

/// Approved record of a claim that Coq has proved.
struct ProvedClaim {
  std::string hash;    ///< hash of the checked file
  std::string proved;  ///< the proved statement in words
  double margin = 0;   ///< lower bound of the printed value's error; 0: none
};
/// Proved claims by claim id.
using ProvedClaims = std::map<std::string, ProvedClaim, std::less<>>;

/// Hash of a file: 64 bits by FNV-1a, the same on all machines.
std::string proof_hash(std::string_view file);

/// Reads proofs.csv in `folder`. Throws BadInput with file and line if it is missing or broken.
ProvedClaims read_proofs(const std::filesystem::path& folder);
/// Text of proofs.csv.
std::string proofs_csv(const ProvedClaims&);

}  // namespace oddity
