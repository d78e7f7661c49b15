#pragma once

#include <functional>
#include <string>
#include <vector>

#include "chapters/claims.hpp"
#include "problem/file.hpp"
#include "reference/verdicts.hpp"

/// The claims of a problem's file, judged as the book's claims are (chapters/claims.hpp).
namespace oddity::problem {

class Sheet {
 public:
  /// Reads all formulas. Throws WrongFile. `exercise` is the prefix of the claims' names. The file must
  /// outlive it.
  Sheet(const File&, std::string exercise);

  std::vector<Claim> judged() const;
  /// The verdicts that the file itself expects: what has only `printed` is confirmed, what has `corrected` is
  /// wrong, or with `in_view` incomplete, and what has `meant` a misprint.
  const Verdicts& stated() const { return stated_; }

 private:
  std::string exercise_;
  std::vector<std::function<void(Claims&)>> claims_;
  Verdicts stated_;
};

}  // namespace oddity::problem
