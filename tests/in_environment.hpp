#pragma once

#include <cmath>
#include <cstdlib>
#include <string>

#include "reference/bad_input.hpp"
#include "reference/text.hpp"

namespace oddity {

/// A whole number from the environment. Throws BadInput for anything else, as a word would count as none.
inline int in_environment(const char* name, int usual) {
  const char* text = std::getenv(name);
  if (!text || !*text) return usual;
  const auto number = parse_number(text);
  if (!number || !(*number >= 0 && *number < 1e9) || *number != std::floor(*number))
    throw BadInput(std::string(name) + " must be a whole number, and is " + text);
  return static_cast<int>(*number);
}

}  // namespace oddity
