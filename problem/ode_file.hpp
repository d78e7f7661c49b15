#pragma once

#include <memory>
#include <string>

#include "problem/file.hpp"

/// XPPAUT's .ode files, as the same File that a TOML file is read as:
///
///   x' = v
///   v' = -k*x - c*v
///   par k=40, c=.1
///   init x=1
///   @ total=30, dt=.02
///
/// All numbers are pure. README.md has what is read, and what is refused.
namespace oddity::problem {

bool is_ode_file(const std::string& name);

/// Reads a text, and nothing that it names; throws WrongFile. The error asked for is left open.
std::unique_ptr<File> read_ode(const std::string& name, const std::string& text);

}  // namespace oddity::problem
