#pragma once

#include <string>

#include "formula/tree.hpp"

namespace oddity::formula {

/// A formula as a page has it, with the parentheses that it needs. parse_tex() reads the same tree's value.
std::string tex(const Tree&);
/// As one types it. parse_plain() reads it where it has no sums over indices, integrals or matrices.
std::string plain(const Tree&);
/// Presentation MathML, without the <math> around it.
std::string mathml(const Tree&);
/// In pieces, each in its own <math>, between which a line may end: before relations and signs, and after
/// commas, of what is long.
std::string mathml_in_pieces(const Tree&);
/// What stands around the places of Kind::marked.
struct Marks {
  std::string begin, end;
};
/// In Unicode's signs, as a terminal shows it: θ'² ≤ (1/2)√(g/L).
std::string unicode(const Tree&, const Marks& = {});
/// A formula that is shown with each operand in brackets of its own, as the grammar reads it: a/bc as (a/b)c.
Tree with_all_brackets(const Tree&);

}  // namespace oddity::formula
