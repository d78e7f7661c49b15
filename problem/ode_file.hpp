#pragma once

#include <memory>
#include <string>

#include "problem/file.hpp"

/// Reads XPPAUT's .ode files into the same File as TOML:
///
///   x' = v
///   v' = -k*x - c*v
///   par k=40, c=.1
///   init x=1
///   @ total=30, dt=.02
///
/// All numbers are pure. README.md lists the supported and the refused statements.
namespace oddity::problem {

bool is_ode_file(const std::string& name);

/// Reads a text, and no file that it names; throws WrongFile. Sets no error for the need.
std::unique_ptr<File> read_ode(const std::string& name, const std::string& text);

}  // namespace oddity::problem
