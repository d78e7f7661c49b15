#pragma once

#include <string_view>
#include <utility>

#include "formula/tree.hpp"
#include "formula/unreadable.hpp"

namespace oddity::formula {

/// Reads TeX in any letters, to print it: by the grammar of parse_tex(), and besides it relations, lists,
/// sets, signs without factors, units, words and accents. Brackets stay as they are written, also one that
/// has no other. Throws Unreadable where a brace has no other, or a command is not known.
Tree parse_shown(std::string_view tex);

/// Both with what the other one has not put into Kind::marked: terms, factors, letters, signs.
std::pair<Tree, Tree> with_differences_marked(const Tree&, const Tree&);

}  // namespace oddity::formula
