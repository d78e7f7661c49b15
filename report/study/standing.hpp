#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "chapters/exercise.hpp"
#include "reference/proofs.hpp"

/// Basis of a claim's verdict: a proof, or a computation in its place.
namespace oddity {

enum class Standing {
  proved,     ///< by Coq
  provable,   ///< nobody has written a proof yet
  computed,   ///< no proof is possible
  wording,    ///< it is about words
  unclassed,  ///< nothing is recorded
};
std::string_view name_of(Standing);

/// "formulas" for samples, "numbers", "cases" for counts, or "words".
std::string_view stated_in(const Claim&);

struct Basis {
  Standing standing = Standing::unclassed;
  std::string why = {};  ///< the proved statement, or why there is no proof
  std::string row = {};  ///< its row of unproved.csv: "3.5-value", "3.5 numbers", "all words"
};

/// proofs.csv and unproved.csv. A claim is proved, or covered by its own row, by one for its exercise's
/// claims stated in the same way, or by one for all such claims.
class Standings {
 public:
  Standings() = default;
  /// Reads both from `folder`. Throws BadInput naming file and line when one is missing or broken.
  explicit Standings(const std::filesystem::path& folder);

  Basis of(const Claim&) const;
  const ProvedClaims& proved() const { return proved_; }
  const std::map<std::string, Basis>& rows() const { return rows_; }

 private:
  ProvedClaims proved_;
  std::map<std::string, Basis> rows_;
};

}  // namespace oddity
