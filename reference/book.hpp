#pragma once

#include <array>
#include <cstddef>

namespace oddity {

/// The book's chapters, from the first on: their odd exercises 1, 3, ..., so many, have published solutions;
/// 0: none has.
inline constexpr std::array last_odd_exercises{0, 17, 35, 0, 15, 5, 11, 5, 1, 0, 0, 0, 0, 0};

/// Whether the published solutions are about this exercise; else it is one of one's own.
constexpr bool is_published(int chapter, int index) {
  return chapter >= 1 && static_cast<std::size_t>(chapter) <= last_odd_exercises.size() && index % 2 == 1 &&
         index <= last_odd_exercises[static_cast<std::size_t>(chapter - 1)];
}

}  // namespace oddity
