#pragma once

#include <string>
#include <string_view>

#include "chapters/contents.hpp"

/// Parts of every program that is printed.
namespace oddity {

/// The names of the columns: the time and the observables.
std::string header_line(const Scene&);
/// A count as digits alone: 100000, where format_shortest has 1e+05, which is no integer.
std::string integer_text(double);
/// A parameter's line, with its unit and meaning: "const double g = 9.81;  // m/s^2: gravity".
std::string parameter_line(const Parameter&, std::string_view type, std::string_view name,
                           std::string_view value);
/// Each line as a comment of one line.
std::string as_comment(const std::string& text);

}  // namespace oddity
