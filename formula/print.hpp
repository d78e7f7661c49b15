#pragma once

#include <string>

#include "formula/tree.hpp"

namespace oddity::formula {

/// A formula in TeX, with the parentheses that it needs. parse_tex() reads a tree of the same value.
std::string tex(const Tree&);
/// The formula as typed text. parse_plain() reads it unless it has sums over indices, integrals or matrices.
std::string plain(const Tree&);
/// Presentation MathML, without the <math> around it.
std::string mathml(const Tree&);
/// MathML in pieces, each in its own <math>, between which a line may break: before relations and signs, and
/// after commas, of long formulas.
std::string mathml_in_pieces(const Tree&);
/// Text before and after the places of Kind::marked.
struct Marks {
  std::string begin, end;
};
/// In Unicode, as a terminal shows it: θ'² ≤ (1/2)√(g/L).
std::string unicode(const Tree&, const Marks& = {});
/// The shown formula with brackets around each operand, as the grammar reads it: a/bc as (a/b)c.
Tree with_all_brackets(const Tree&);

}  // namespace oddity::formula
