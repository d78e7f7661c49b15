#include "reference/errors.hpp"

#include <sstream>

#include "reference/bad_input.hpp"
#include "reference/csv.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace {

std::vector<std::optional<double>> numbers_in(const CsvRow& row, std::size_t i) {
  std::vector<std::optional<double>> numbers;
  std::istringstream words(row.cells[i]);
  for (std::string word; words >> word;) {
    numbers.push_back(word == by_last_bits ? std::nullopt : parse_number(word));
    if (word != by_last_bits && !numbers.back())
      throw BadInput(row.place + ": '" + word + "' is neither a number nor " + std::string(by_last_bits));
  }
  return numbers;
}

}  // namespace

std::vector<ErrorsOnRecord> read_errors(const std::filesystem::path& folder) {
  std::vector<ErrorsOnRecord> all;
  for (const CsvRow& row : read_rows(folder / "errors.csv", {"exercise", "of", "at", "errors", "work"}, 2))
    all.push_back(
        {row.cells[0], row.cells[1], row.cells[2], numbers_in(row, 3), numbers_in(row, 4), row.place});
  return all;
}

}  // namespace oddity
