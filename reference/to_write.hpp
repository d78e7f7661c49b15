#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// What `oddity new` leaves to be written, marked such that the suite names it and its place.
namespace oddity {

/// Before the place, or before what is missing.
inline constexpr std::string_view to_write_mark = "still to be written: ";

inline std::string to_write_at(const char* file, int line) {
  return std::string(to_write_mark) + file + ":" + std::to_string(line);
}

namespace truth {

/// What a maker's route throws until it is written: nothing is known by it.
struct StillToWrite : std::logic_error {
  explicit StillToWrite(const std::vector<double>& /*inputs*/, const char* file = __builtin_FILE(),
                        int line = __builtin_LINE())
      : std::logic_error(to_write_at(file, line)) {}
};

}  // namespace truth

}  // namespace oddity
