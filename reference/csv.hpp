#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace oddity {

/// One line of a CSV file; `place` is "file:line" for messages.
struct CsvRow {
  std::string place;
  std::vector<std::string> cells;

  /// Cell i as a number. Throws BadInput with the place if it is not a number.
  double number(std::size_t i) const;
};

/// A CSV file without its comment lines (#): a header and rows with equal numbers of cells.
struct CsvFile {
  CsvRow header;
  std::vector<CsvRow> rows;
};

/// Throws BadInput with the file, and the line if known, if it is missing or broken.
CsvFile read_csv(const std::filesystem::path& file);

/// The rows of a file that must have exactly these columns. Throws BadInput as read_csv, and if two rows
/// begin with the same `keys` cells.
std::vector<CsvRow> read_rows(const std::filesystem::path& file, const std::vector<std::string>& columns,
                              std::size_t keys);

/// The text as one cell for `read_csv`: quoted and with doubled backslashes if necessary.
std::string csv_cell(const std::string& text);

}  // namespace oddity
