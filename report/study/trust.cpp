#include "report/study/trust.hpp"

#include <algorithm>
#include <cmath>

#include "reference/bad_input.hpp"
#include "reference/csv.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

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

Bounds bounds_of(const fs::path& tables) {
  Bounds all;
  for (const auto& file : fs::directory_iterator(tables)) count(file.path(), all);
  return all;
}

Witnessed witnessed_in(const fs::path& folder) {
  Witnessed all;
  if (!fs::exists(folder / "witness.csv")) return all;
  for (const CsvRow& row : read_csv(folder / "witness.csv").rows)
    (row.cells.at(1) == "both" || row.cells[1] == "right" ? all.at_its_letters : all.at_others)
        .insert(row.cells[0]);
  if (fs::exists(folder / "words.csv"))
    for (const CsvRow& row : read_csv(folder / "words.csv").rows) all.words.insert(row.cells.at(0));
  return all;
}

/// A row whose cells are read by column name.
class Record {
 public:
  Record(const CsvRow& header, const CsvRow& row) : header_(header), row_(row) {}

  const std::string& text(const std::string& column) const { return row_.cells[at(column)]; }
  double number(const std::string& column) const { return row_.number(at(column)); }
  long count(const std::string& column) const { return std::lround(number(column)); }
  Tried tried(const std::string& subject) const { return {text("date"), text("commit"), text(subject)}; }

 private:
  std::size_t at(const std::string& column) const {
    const auto found = std::ranges::find(header_.cells, column);
    if (found == header_.cells.end()) throw BadInput(header_.place + ": there is no column " + column);
    return static_cast<std::size_t>(found - header_.cells.begin());
  }
  const CsvRow& header_;
  const CsvRow& row_;
};

/// Empty if there is no such file.
template <class Row, class Read>
std::vector<Row> records(const fs::path& file, const Read& read) {
  std::vector<Row> all;
  if (!fs::exists(file)) return all;
  const CsvFile csv = read_csv(file);
  for (const CsvRow& row : csv.rows) all.push_back(read(Record(csv.header, row)));
  return all;
}

Mutated mutated(const Record& r) {
  return {r.tried("room"),        r.count("mutants"),  r.count("tried"),       r.count("killed"),
          r.count("with_reason"), r.count("survived"), r.count("first_tried"), r.count("first_killed")};
}
Fuzzed fuzzed(const Record& r) {
  return {r.tried("target"), r.count("inputs"), r.count("crashes"), r.number("seconds")};
}
Faulted faulted(const Record& r) {
  return {r.tried("verb"), r.text("fault"), r.count("trials"), r.count("failures")};
}

std::vector<Assertion> assertions_in(const fs::path& reference) {
  std::vector<Assertion> all;
  if (!fs::exists(reference / "ledger")) return all;
  for (const fs::directory_entry& file : fs::directory_iterator(reference / "ledger"))
    if (file.path().extension() == ".csv")
      for (Assertion& one : read_ledger(reference, file.path().stem().string()))
        all.push_back(std::move(one));
  return all;
}

}  // namespace

Trust read_trust(const fs::path& reference) {
  return {Standings(reference / "approved"),
          assertions_in(reference),
          bounds_of(reference / "tables"),
          witnessed_in(reference / "witness"),
          records<Mutated>(reference / "trust" / "mutation.csv", mutated),
          records<Fuzzed>(reference / "trust" / "fuzz.csv", fuzzed),
          records<Faulted>(reference / "trust" / "faults.csv", faulted)};
}

}  // namespace oddity
