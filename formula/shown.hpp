#pragma once

#include <string_view>
#include <utility>

#include "formula/tree.hpp"
#include "formula/unreadable.hpp"

namespace oddity::formula {

/// Reads TeX in any letters, to print it: by the grammar of parse_tex(), plus relations, lists, sets, signs
/// without factors, units, words and accents. Keeps brackets as they are written, even unmatched ones. Throws
/// Unreadable for an unmatched brace or an unknown command.
Tree parse_shown(std::string_view tex);

/// Both trees, with their differences in Kind::marked: terms, factors, letters, signs.
std::pair<Tree, Tree> with_differences_marked(const Tree&, const Tree&);

}  // namespace oddity::formula
