#pragma once

#include <array>
#include <cstddef>

namespace oddity {

/// For each chapter of the book, the last of the odd exercises 1, 3, ... with published solutions; 0: none
/// has.
inline constexpr std::array last_odd_exercises{0, 17, 35, 0, 15, 5, 11, 5, 1, 0, 0, 0, 0, 0};

/// Whether the published solutions cover this exercise; otherwise it is a reader's own.
constexpr bool is_published(int chapter, int index) {
  return chapter >= 1 && static_cast<std::size_t>(chapter) <= last_odd_exercises.size() && index % 2 == 1 &&
         index <= last_odd_exercises[static_cast<std::size_t>(chapter - 1)];
}

}  // namespace oddity
