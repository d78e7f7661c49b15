#pragma once

#include <string>
#include <string_view>

namespace oddity {

/// Of C++ that is formatted as here, what a program needs that has these words: types, functions and
/// variables by name, with what they mention in turn; of a type that is needed, its data, constructors and
/// operators, and the other members that are mentioned anywhere. Overloads stay together. What does not read
/// as declarations stays.
///   used_code("struct A {};\nstruct B {\n  A a;\n};\nstruct C {};\n", "B b;")  // A and B
std::string used_code(std::string_view code, std::string_view words);

/// Whether a program of this text needs the standard header <name>: false only where it is known and unused.
bool needs_standard(std::string_view name, std::string_view code);

}  // namespace oddity
