#pragma once

#include <string_view>

namespace oddity::problem {

/// A commented problem's file to start from, which runs as it is.
extern const std::string_view begun;

}  // namespace oddity::problem
