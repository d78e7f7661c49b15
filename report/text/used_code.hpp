#pragma once

#include <string>
#include <string_view>

namespace oddity {

/// The part of `code` that a program with these words needs. Functions, variables and types are selected by
/// name, together with the names that they mention. A type that is needed keeps its data, constructors,
/// operators, and the members that are mentioned anywhere. Overloads stay together. Text that does not read
/// as declarations stays. The code must be formatted as in this project.
///   used_code("struct A {};\nstruct B {\n  A a;\n};\nstruct C {};\n", "B b;")  // A and B
std::string used_code(std::string_view code, std::string_view words);

/// Whether this code needs the standard header <name>: false only for known headers that it does not use.
bool needs_standard(std::string_view name, std::string_view code);

}  // namespace oddity
