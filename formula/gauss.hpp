#pragma once

#include <array>

namespace oddity::formula {

/// Nodes and weights of Gauss's rule on [-1, 1], in pairs.
const std::array<std::array<double, 2>, 64>& gauss_64();

}  // namespace oddity::formula
