#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "chapters/claims.hpp"
#include "problem/file.hpp"

/// The claims of a problem's file, judged as the book's claims are (chapters/claims.hpp).
namespace oddity::problem {

class Sheet {
 public:
  /// Reads all formulas. Throws WrongFile. `exercise` is the prefix of the claims' names. The file must
  /// outlive it.
  Sheet(const File&, std::string exercise);

  std::size_t size() const { return claims_.size(); }
  /// One of them, by its place in the file.
  Claim judged(std::size_t) const;
  std::vector<Claim> judged() const;
  /// The verdicts that the file itself expects. A claim with only `printed` is confirmed. One with
  /// `corrected` is wrong, or with `in_view` incomplete; one with `meant` is a misprint.
  const std::map<std::string, std::string, std::less<>>& stated() const { return stated_; }

 private:
  std::string exercise_;
  std::vector<std::function<void(Claims&)>> claims_;
  std::map<std::string, std::string, std::less<>> stated_;  ///< by the claim's id
};

}  // namespace oddity::problem
