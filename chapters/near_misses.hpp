#pragma once

#include <string>
#include <vector>

#include "chapters/typeset.hpp"

/// Near misses of a formula that is stated as text alone: each single change of it, by formula/mutants.hpp.
namespace oddity {

/// A sample's letters, what the formula is to be there, and the size of its terms.
struct TypesetSample {
  TypesetLetters letters;
  Value truth;
};

struct ChangedFormula {
  std::string text;                  ///< of the whole, as a page has it
  std::string change;                ///< "$g$ for $m_2$"
  std::vector<formula::Tree> sides;  ///< for TypesetFormula::value
  double roundings = 0;  ///< the largest difference from the truth, in roundings of the terms' size
};

struct Changes {
  std::vector<ChangedFormula> hardest_first;
  std::size_t equal = 0;  ///< changes that leave the value for any letters whatever: x^1 for x
};

/// All changes of the formula, but for equations' both sides at once. Empty without samples.
Changes changes_of(const TypesetFormula&, const std::vector<TypesetSample>&);

}  // namespace oddity
