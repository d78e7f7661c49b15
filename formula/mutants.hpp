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

/// Every sign flipped; every term and factor dropped, doubled and halved; every digit one more and one less;
/// every letter exchanged for each other in the formula, and for its rate; indices exchanged; quotients made
/// products and turned over; powers, roots, bars and functions left out; functions exchanged for neighbours;
/// the order of cross products and components.
std::vector<Mutant> mutants(const Tree&);

}  // namespace oddity::formula
