#pragma once

#include <string>
#include <string_view>

/// The expressions of listings (exercise.hpp).
namespace oddity {

/// Whether an expression has this name as a word.
bool mentions(std::string_view expression, std::string_view name);
/// An expression, which is in double, in another number type.
std::string in_number_type(std::string_view expression, std::string_view number);

}  // namespace oddity
