#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "chapters/exercise.hpp"
#include "reference/proofs.hpp"

/// What the claims' verdicts rest on: a proof, or what is computed in place of one.
namespace oddity {

enum class Standing {
  proved,     ///< by Coq
  provable,   ///< nobody has written a proof yet
  computed,   ///< no proof is to be had
  wording,    ///< it is about words
  unclassed,  ///< nothing is on record
};
std::string_view name_of(Standing);

/// "formulas" that are compared over samples, "numbers", "cases" that are counted, or "words".
std::string_view stated_in(const Claim&);

struct Basis {
  Standing standing = Standing::unclassed;
  std::string why = {};  ///< of a proof what is proved, else why there is none
  std::string row = {};  ///< of unproved.csv that says so: "3.5-value", "3.5 numbers", "all words"
};

/// proofs.csv and unproved.csv: a claim is proved, or has a row of its own, or one for its exercise's claims
/// that are stated so, or one for all that are.
class Standings {
 public:
  Standings() = default;
  /// Reads both in `folder`. Throws BadInput naming file and line when one is missing or broken.
  explicit Standings(const std::filesystem::path& folder);

  Basis of(const Claim&) const;
  const ProvedClaims& proved() const { return proved_; }
  const std::map<std::string, Basis>& rows() const { return rows_; }

 private:
  ProvedClaims proved_;
  std::map<std::string, Basis> rows_;
};

}  // namespace oddity
