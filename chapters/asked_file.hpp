#pragma once

#include <string>

#include "chapters/contents.hpp"

namespace oddity {

/// Number for the exercise in a file, which belongs to no chapter; to_string() returns the given name for it.
Number number_of_file(std::string name);

}  // namespace oddity
