#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// Places where a source can be mutated, as read by libclang.
namespace oddity::mutation {

/// Part of a file's text, from `begin` up to `end`.
struct Extent {
  unsigned begin = 0, end = 0;
  auto operator<=>(const Extent&) const = default;
};

enum class Shape {
  operation,   ///< a op b becomes operation(i, a, b, op, another)
  assignment,  ///< a op= b becomes assignment(i, a, b, op=, another)
  comparison,  ///< a < b becomes less(i, a, b)
  sign,        ///< -a becomes negative(i, a, op)
  literal,     ///< 2 becomes function(i, 2)
  logic,       ///< a && b: either operand is ignored
  condition,   ///< if (a): the opposite
  statement    ///< f(); or a = b; is left out
};

/// A place in a file and the mutants there, one for each entry of `mutations`: "+ to -".
struct Point {
  Shape shape;
  std::string function;  ///< in mutant.hpp, or && or ||
  Extent whole, op;
  std::string operators[2];  ///< the operator, and the one that it becomes
  std::string within;        ///< the function of the source that it is in
  std::vector<std::string> mutations;
  bool free = false;  ///< nothing has to notice: see free_below() in points.cpp
};

/// A file to be mutated, and its points in order.
struct Mutable {
  std::string file;  ///< path within the tree
  std::string text;
  std::vector<Point> points;
  int first = 1;     ///< the number of its first mutant, see number_files()
  int left_out = 0;  ///< places of the same kinds that the compiler computes
  int free = 0;      ///< number of mutants at free places, which `points` does not contain
};

/// Reads the files of the tree that are wanted and that the compile commands reach. `compiled` is the folder
/// of compile_commands.json; throws BadInput if that is missing. Results are kept in the file `kept_in`, for
/// runs that want the same files.
std::vector<Mutable> mutable_files(const std::filesystem::path& tree, const std::filesystem::path& compiled,
                                   const std::function<bool(const std::string& file)>& wanted,
                                   const std::filesystem::path& kept_in);

}  // namespace oddity::mutation
