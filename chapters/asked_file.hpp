#pragma once

#include <string>

#include "chapters/contents.hpp"

namespace oddity {

/// A number for what a file asks, which is in no chapter: to_string() gives the name in its place.
Number number_of_file(std::string name);

}  // namespace oddity
