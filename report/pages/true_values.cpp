#include "report/pages/true_values.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "reference/csv.hpp"
#include "reference/text.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

struct Bounds {
  std::size_t values = 0, enclosed = 0;
  double widest = 0;             ///< error of an enclosed value, over the largest component of its row
  std::set<std::string> agreed;  ///< tables with values that are not
};

void count(const fs::path& file, Bounds& all) {
  const CsvFile csv = read_csv(file);
  const auto& columns = csv.header.cells;
  const auto n = static_cast<std::size_t>(std::ranges::find(columns, "component") - columns.begin());
  const auto inputs = [&](const CsvRow& row) {
    return std::vector(row.cells.begin(), row.cells.begin() + static_cast<std::ptrdiff_t>(n));
  };
  for (std::size_t first = 0, end = 0; first < csv.rows.size(); first = end) {
    double size = 0;
    for (; end < csv.rows.size() && inputs(csv.rows[end]) == inputs(csv.rows[first]); ++end)
      size = std::max(size, std::abs(csv.rows[end].number(n + 1)));
    for (std::size_t k = first; k < end; ++k) {
      ++all.values;
      if (csv.rows[k].cells[n + 3] == "enclosure") {
        ++all.enclosed;
        if (size > 1e-40) all.widest = std::max(all.widest, csv.rows[k].number(n + 2) / size);
      } else {
        all.agreed.insert(file.stem().string());
      }
    }
  }
}

}  // namespace

std::string true_values(const fs::path& folder) {
  Bounds all;
  for (const auto& file : fs::directory_iterator(folder / "tables")) count(file.path(), all);
  std::string text =
      "## The true values\n\nOf the " + std::to_string(all.values) + " values in the reference tables " +
      std::to_string(all.enclosed) +
      " are enclosed: computed with numbers that carry a proved bound of their error, the widest " +
      format_significant(all.widest, 1) + " of the largest component beside it.";
  if (!all.agreed.empty()) {
    text += " The other " + std::to_string(all.values - all.enclosed) + " rest on two routes that agree:";
    for (const std::string& table : all.agreed)
      text += (table == *all.agreed.begin() ? " `" : ", `") + table + "`";
    text += ".";
  }
  return text + "\n";
}

}  // namespace oddity
