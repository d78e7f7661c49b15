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
  std::string change;                ///< "$g$ for $m_2$"
  std::vector<formula::Tree> sides;  ///< for TypesetFormula::value
  /// The largest difference from the truth, in roundings of the terms' size. Exact up to `clear`, and for the
  /// `exact` hardest beyond; others have at least this one.
  double roundings = 0;

  std::string text() const;  ///< the whole formula, as a page shows it
};

/// Changes with more roundings fail, except within the tolerance of a truth that is less accurate.
inline constexpr double clear = 1e6;
/// Usually enough: where more of them hold, all are computed exactly.
inline constexpr std::size_t exact_ones = 8;

struct Changes {
  std::vector<ChangedFormula> hardest_first;
  std::size_t equal = 0;  ///< changes that leave the value the same for any letters: x^1 for x
};

/// All changes of the formula, except those of both sides of an equation at once. Empty without samples.
Changes changes_of(const TypesetFormula&, const std::vector<TypesetSample>&, std::size_t exact = exact_ones);

}  // namespace oddity
