#pragma once

#include <string_view>

namespace oddity::problem {

/// A problem's file to begin with, commented, which runs as it is.
extern const std::string_view begun;

}  // namespace oddity::problem
