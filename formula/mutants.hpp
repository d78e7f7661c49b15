#pragma once

#include <string>
#include <vector>

#include "formula/tree.hpp"

namespace oddity::formula {

/// A formula that differs from another at one place.
struct Mutant {
  Tree tree;
  std::string change;  ///< in words: "$g$ for $m_2$", "the sign of $mg$", "$2$ dropped"
};

/// Mutants of a formula. Every sign is flipped. Every term and factor is dropped, doubled and halved. Every
/// digit is raised and lowered by one. Every letter is exchanged for each other letter of the formula, and
/// for its rate. Indices are exchanged. Quotients become products and are inverted. Powers, roots, bars and
/// functions are left out, and functions exchanged for similar ones. The order of cross products and
/// components is changed.
std::vector<Mutant> mutants(const Tree&);

}  // namespace oddity::formula
