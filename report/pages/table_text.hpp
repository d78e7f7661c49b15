#pragma once

#include <string>
#include <variant>
#include <vector>

/// Tables for other programs to read.
namespace oddity {

using Cell = std::variant<std::string, double, long>;

struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;  ///< each with as many cells as there are columns
};

/// Comma-separated values as in RFC 4180, but lines end with "\n"; a number that is not finite is inf, -inf
/// or nan.
std::string to_csv(const Table&);
/// A list of objects, one for each row; a number that is not finite is null.
std::string to_json(const Table&);

}  // namespace oddity
