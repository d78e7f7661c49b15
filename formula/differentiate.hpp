#pragma once

#include <functional>
#include <optional>
#include <string>

#include "formula/tree.hpp"
#include "formula/unreadable.hpp"

namespace oddity::formula {

/// The derivative of a letter, if it has one.
using Slope = std::function<std::optional<Tree>(const Tree& letter)>;

/// The derivative along these slopes of the letters. Throws NoValue if it does not exist: for \max, and for
/// an integral whose bounds change.
Tree differentiate(const Tree&, const Slope&);

/// The derivative with respect to a letter that is a number, by its name in the tree.
Tree differentiate(const Tree&, const std::string& letter);

/// The node \frac{d}{dt} of a tree, with its derivative along the letters' rates.
Tree time_derivative_of(const Tree&);

/// Replaces each letter for which the function returns a tree.
Tree substitute(const Tree&, const std::function<std::optional<Tree>(const Tree& letter)>&);

}  // namespace oddity::formula
