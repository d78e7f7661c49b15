#include "reference/verdicts.hpp"

#include <algorithm>
#include <array>

#include "reference/bad_input.hpp"
#include "reference/csv.hpp"

namespace oddity {

Verdicts read_verdicts(const std::filesystem::path& folder) {
  static constexpr std::array<std::string_view, 7> known{
      "confirmed", "misprint", "lost in our copy", "incomplete", "wrong", "not checkable", "unsettled"};
  Verdicts verdicts;
  for (const CsvRow& row : read_csv(folder / "verdicts.csv").rows) {
    if (row.cells.size() != 2) throw BadInput(row.place + ": the columns are claim,verdict");
    if (std::ranges::find(known, row.cells[1]) == known.end())
      throw BadInput(
          row.place + ": '" + row.cells[1] +
          "' is no verdict; it is one of confirmed, misprint, lost in our copy, incomplete, wrong, not checkable, unsettled");
    if (!verdicts.emplace(row.cells[0], row.cells[1]).second)
      throw BadInput(row.place + ": a second verdict for " + row.cells[0]);
  }
  return verdicts;
}

}  // namespace oddity
