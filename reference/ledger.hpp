#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace oddity {

/// One assertion of a published solution, in our words. `reference/ledger/3.19.csv` has those of 3.19, each
/// with the claims that judge it, or the reason for having none.
///   line,place,assertion,claims,reason
///   2541,"equation of the forces","the small pulley's force is the weight less the first spring's",force_y2,
struct Assertion {
  int line = 0;                     ///< in the solutions document as plain text
  std::string place;                ///< place for a reader of the manual
  std::string assertion;            ///< a paraphrase
  std::vector<std::string> claims;  ///< "3.19-force_y2"; `reason` explains an empty list
  std::string reason;
};

/// The ledger of the exercise "3.19" in a folder of references; empty if it has none. Throws BadInput with
/// file and line for a row that has neither claims nor a reason, or both, or no place.
std::vector<Assertion> read_ledger(const std::filesystem::path& folder, const std::string& exercise);

}  // namespace oddity
