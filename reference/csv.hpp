#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace oddity {

/// One line of a CSV file; `place` is "file:line" for messages.
struct CsvRow {
  std::string place;
  std::vector<std::string> cells;

  /// Cell i as a number. Throws BadInput naming the place when it is none.
  double number(std::size_t i) const;
};

/// A CSV file without its lines of comment (#): a header and rows of equally many cells.
struct CsvFile {
  CsvRow header;
  std::vector<CsvRow> rows;
};

/// Throws BadInput naming the file, and the line where there is one, when it is missing or broken.
CsvFile read_csv(const std::filesystem::path& file);

/// The rows of a file that has exactly these columns; likewise, and when two rows begin with the same `keys`
/// cells.
std::vector<CsvRow> read_rows(const std::filesystem::path& file, const std::vector<std::string>& columns,
                              std::size_t keys);

/// The text as one cell that `read_csv` reads: quoted, and its backslashes doubled, where that has to be.
std::string csv_cell(const std::string& text);

}  // namespace oddity
