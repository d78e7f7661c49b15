#pragma once

#include <string>
#include <variant>
#include <vector>

#include "report/text/screen.hpp"

/// Tables for other programs and for a screen.
namespace oddity {

using Cell = std::variant<std::string, double, long>;

struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<Cell>> rows;  ///< each with as many cells as there are columns
};

/// Comma-separated values as in RFC 4180, except that lines end with "\n". Numbers that are not finite are
/// inf, -inf or nan.
std::string to_csv(const Table&);
/// A list of objects, one per row; numbers that are not finite are null.
std::string to_json(const Table&);

/// How to fit a table to a narrow screen. Columns are named as in its first row.
struct Fitting {
  std::vector<std::string> shorten = {};    ///< columns whose cells may be cut
  std::vector<std::string> leave_out = {};  ///< columns to drop if that is not enough, in this order
  bool first_above = false;  ///< first of all, put the first column's values on lines above their rows
};

/// Rows as aligned columns, two spaces apart and indented by two. With a Fitting the first row is a heading,
/// the columns fit the screen, and a last line names the columns left out.
std::string aligned(std::vector<std::vector<std::string>> rows, const Screen& = {}, const Fitting& = {});

}  // namespace oddity
