#include "reference/limits.hpp"

#include "reference/bad_input.hpp"
#include "reference/csv.hpp"

namespace oddity {

namespace {

double step_in(const CsvRow& row, std::size_t i) {
  const double step = row.number(i);
  if (!(step >= 0)) throw BadInput(row.place + ": a step must be zero or positive, or inf");
  return step;
}

/// Stars and dots, one for each outcome; or empty.
std::string marks_in(const CsvRow& row, std::size_t i, const std::string& outcomes) {
  const std::string& marks = row.cells[i];
  const bool one_each = marks.size() == outcomes.size() && marks.find_first_not_of(".*") == std::string::npos;
  if (!marks.empty() && !one_each)
    throw BadInput(row.place + ": '" + marks + "' in column " + std::to_string(i + 1) +
                   " must be a dot or a star for each outcome, or empty");
  return marks;
}

std::optional<double> number_or_none(const CsvRow& row, std::size_t i) {
  return row.cells[i].empty() ? std::nullopt : std::optional(row.number(i));
}

}  // namespace

Limits read_limits(const std::filesystem::path& folder) {
  Limits limits;
  for (const CsvRow& row : read_rows(folder / "limits.csv",
                                     {"exercise", "model", "algorithm", "step", "theory", "unstable",
                                      "watched", "soft", "error", "needed", "beyond", "why"},
                                     3))
    limits.push_back({row.cells[0], row.cells[1], row.cells[2], step_in(row, 3), step_in(row, 4),
                      row.cells[5], number_or_none(row, 6), row.cells[7], number_or_none(row, 8),
                      number_or_none(row, 9), row.cells[10], row.cells[11], row.place});
  return limits;
}

Maps read_maps(const std::filesystem::path& folder) {
  Maps maps;
  for (const CsvRow& row : read_rows(folder / "stability_maps.csv",
                                     {"exercise", "model", "algorithm", "value", "outcomes", "fragile"}, 4))
    maps.push_back({row.cells[0], row.cells[1], row.cells[2], row.number(3), row.cells[4],
                    marks_in(row, 5, row.cells[4]), row.place});
  return maps;
}

}  // namespace oddity
