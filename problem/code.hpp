#pragma once

#include <string>
#include <vector>

#include "problem/expression.hpp"
#include "problem/file.hpp"

/// A program's operations as lines of C++.
namespace oddity::problem {

struct Written {
  std::string lines;                 ///< what is used more than once, each with a name
  std::vector<std::string> outputs;  ///< expressions in the inputs' names and those of the lines
  std::vector<char> used;            ///< by input: whether an output needs it
};

/// `names` are of the inputs, in their order. `indent` goes before each line.
Written written(const Program&, const std::vector<std::string>& names, const std::string& indent);

/// A model's equations as a comment above its code.
std::string comment_of(const File&, const ModelText&);

/// The name of a type for what is called so: "spring and friction" is SpringAndFriction.
std::string type_name(const std::string& called);

/// Whether a variable of C++ cannot or should not have this name: M_E is a macro.
bool is_taken_in_cpp(const std::string& name);

}  // namespace oddity::problem
