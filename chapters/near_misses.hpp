#pragma once

#include <string>
#include <vector>

#include "chapters/typeset.hpp"

/// Near misses of a formula that is stated as text alone: all its single changes, from formula/mutants.hpp.
namespace oddity {

/// A sample's letters and the formula's true value there.
struct TypesetSample {
  TypesetLetters letters;
  Value truth;
};

struct ChangedFormula {
  std::string text;                  ///< the whole formula, as a page shows it
  std::string change;                ///< "$g$ for $m_2$"
  std::vector<formula::Tree> sides;  ///< for TypesetFormula::value
  double roundings = 0;  ///< the largest difference from the truth, in roundings of the terms' size
};

struct Changes {
  std::vector<ChangedFormula> hardest_first;
  std::size_t equal = 0;  ///< changes that leave the value the same for any letters: x^1 for x
};

/// All changes of the formula, except those of both sides of an equation at once. Empty without samples.
Changes changes_of(const TypesetFormula&, const std::vector<TypesetSample>&);

}  // namespace oddity
