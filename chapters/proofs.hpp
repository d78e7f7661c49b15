#pragma once

#include <string>
#include <vector>

#include "solvers/expression.hpp"

/// What is proved of claims: statements about formulas recorded from the templates that the suite evaluates
/// in double.
namespace oddity {

/// One statement about one reading of a claim.
struct Proof {
  enum class Kind {
    identity,  ///< left = right for all letters
    near,      ///< |left - right| <= bound
    far,       ///< bound <= |left - right|: what is printed is wrong, by so much at least
  };
  std::string claim;    ///< its id, such as "3.5-value"
  std::string reading;  ///< "printed" or "corrected"
  Kind kind;
  std::string says;                       ///< what is compared with what, and where
  std::vector<std::string> letters = {};  ///< any real numbers
  Expression left, right;
  std::string bound = "0";  ///< a decimal
};

/// "identity", "near", "far".
std::string to_string(Proof::Kind);
/// Such as "3.5-value_printed", for its file.
std::string name_of(const Proof&);
/// A file that Coq accepts if and only if it finds the proof; it ends by printing what the proof assumes.
std::string coq_file(const Proof&);
/// A script for PARI/GP that prints "true" where the statement holds: within 10^-10 of an identity at a few
/// points; of the others, with the bound.
std::string pari_script(const Proof&);

/// All, in the order of the exercises.
std::vector<Proof> proofs();

}  // namespace oddity
