#pragma once

#include <array>
#include <cstddef>

#include "chapters/numbers.hpp"

namespace oddity {

/// By how much constraints are violated together: the root of the sum of their squares.
template <class T, std::size_t n>
T off_constraints(const std::array<T, n>& constraints) {
  T off = abs(constraints[0]);
  for (std::size_t i = 1; i < n; ++i) off = hypot(off, constraints[i]);
  return off;
}

}  // namespace oddity
