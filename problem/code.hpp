#pragma once

#include <string>
#include <vector>

#include "problem/expression.hpp"
#include "problem/file.hpp"

/// Writes a program's operations as lines of C++.
namespace oddity::problem {

struct Written {
  std::string lines;                 ///< operations used more than once, each with a name
  std::vector<std::string> outputs;  ///< expressions in the names of inputs and lines
  std::vector<char> used;            ///< by input: an output needs it
};

/// `names` are those of the inputs, in order. `indent` goes before each line.
Written written(const Program&, const std::vector<std::string>& names, const std::string& indent);

/// A model's equations as a comment above its code.
std::string comment_of(const File&, const ModelText&);

/// The type's name for a description: "spring and friction" gives SpringAndFriction.
std::string type_name(const std::string& called);

/// Whether a C++ variable cannot or should not have this name: M_E is a macro.
bool is_taken_in_cpp(const std::string& name);

}  // namespace oddity::problem
