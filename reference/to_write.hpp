#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// Unwritten parts left by `oddity new`, marked so that the suite lists them with their place.
namespace oddity {

/// Precedes the place, or the name of the missing part.
inline constexpr std::string_view to_write_mark = "still to be written: ";

inline std::string to_write_at(const char* file, int line) {
  return std::string(to_write_mark) + file + ":" + std::to_string(line);
}

namespace truth {

/// Thrown by a generator's route until it is written.
struct StillToWrite : std::logic_error {
  explicit StillToWrite(const std::vector<double>& /*inputs*/, const char* file = __builtin_FILE(),
                        int line = __builtin_LINE())
      : std::logic_error(to_write_at(file, line)) {}
};

}  // namespace truth

}  // namespace oddity
