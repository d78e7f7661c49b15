#pragma once

#include <string>
#include <variant>
#include <vector>

#include "report/text/screen.hpp"

/// Tables: for other programs to read, and for a screen.
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

/// What may be done to a table that is too wide for its screen, by the names in its first row.
struct Fitting {
  std::vector<std::string> shorten = {};    ///< columns of which ends of words are enough
  std::vector<std::string> leave_out = {};  ///< columns that go where that does not do, the first one first
  bool first_above =
      false;  ///< before all that the first column's values, where not empty, stand above their rows
};

/// Rows as aligned columns, two spaces apart and indented by two. With a Fitting the first row is a heading,
/// the columns fit the screen, and a last line names those that are left out.
std::string aligned(std::vector<std::vector<std::string>> rows, const Screen& = {}, const Fitting& = {});

}  // namespace oddity
