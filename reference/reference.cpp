#include "reference/reference.hpp"

#include <algorithm>
#include <cmath>

#include "reference/bad_input.hpp"
#include "reference/csv.hpp"
#include "reference/text.hpp"
#include "reference/truth.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

/// The columns of every table that follow its inputs.
const std::vector<std::string> tail{"component", "value", "error", "unit"};

std::size_t inputs_of(const CsvFile& csv) {
  const auto& columns = csv.header.cells;
  if (columns.size() < tail.size() || !std::equal(tail.rbegin(), tail.rend(), columns.rbegin()))
    throw BadInput(csv.header.place + ": the columns must end in component,value,error,unit");
  return columns.size() - tail.size();
}

const truth::Entry* maker_of(std::string_view table) {
  const auto& all = truth::registry();
  const auto found = std::ranges::find(all, table, &truth::Entry::name);
  return found == all.end() ? nullptr : &*found;
}

Known on_the_spot(std::string_view table, const std::vector<double>& inputs) {
  const truth::Entry* maker = maker_of(table);
  if (!maker) throw BadInput("no table reference/" + std::string(table) + ".csv");
  const truth::Truth truth = maker->make();
  if (inputs.size() != truth.inputs.size())
    throw BadInput("table " + std::string(table) + " takes " + std::to_string(truth.inputs.size()) +
                   " inputs, not " + std::to_string(inputs.size()));
  const truth::Made made = truth::make_row(truth, inputs, truth::spot_digits);
  Known known{{},
              static_cast<double>(made.error),
              "computed on the spot: " + truth.first_route + "; and " + truth.second_route};
  for (const truth::Number& x : made.value) {
    known.value.push_back(static_cast<double>(x));
    known.error = std::max(known.error, std::abs(known.value.back()) * 0x1p-53);
  }
  return known;
}

}  // namespace

Reference::Reference(const fs::path& folder) {
  for (const truth::Entry& entry : truth::registry()) {
    const std::string name(entry.name);
    tables_.emplace(name, read(folder / (name + ".csv")));
  }
}

Reference::Table Reference::read(const fs::path& file) {
  const CsvFile csv = read_csv(file);
  Table table{file.filename().string(), inputs_of(csv), {}};
  for (const CsvRow& row : csv.rows) {
    std::vector<double> inputs;
    for (std::size_t i = 0; i < table.inputs; ++i) inputs.push_back(row.number(i));
    const double value = row.number(table.inputs + 1);
    const double error = row.number(table.inputs + 2);
    if (!(std::isfinite(value) && error >= 0))
      throw BadInput(row.place + ": value must be finite, error not negative");
    Known& known = table.rows[inputs];
    known.value.push_back(value);
    known.error = std::max({known.error, error, std::abs(value) * 0x1p-53});
    known.source = "table " + table.file;
  }
  return table;
}

Known Reference::operator()(std::string_view name, const std::vector<double>& inputs) const {
  const auto table = tables_.find(name);
  if (table == tables_.end()) throw BadInput("no table reference/" + std::string(name) + ".csv");
  const auto row = table->second.rows.find(inputs);
  return row != table->second.rows.end() ? row->second : on_the_spot(name, inputs);
}

}  // namespace oddity
