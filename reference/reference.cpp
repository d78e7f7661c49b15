#include "reference/reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/bad_input.hpp"
#include "reference/csv.hpp"
#include "reference/text.hpp"
#include "reference/truth.hpp"

namespace oddity {

namespace fs = std::filesystem;

namespace {

/// The columns of a table: its inputs, then these.
std::vector<std::string> columns_of(const truth::Truth& truth) {
  std::vector<std::string> columns = truth.inputs;
  for (const char* column : {"component", "value", "error", "unit"}) columns.emplace_back(column);
  return columns;
}

std::string listed(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ",") + word;
  return list;
}

std::string listed(const std::vector<double>& numbers) {
  std::vector<std::string> words;
  for (double x : numbers) words.push_back(shortest(x));
  return listed(words);
}

/// The rows of a table, each with all of its components in their order.
std::map<std::vector<double>, Known> read(const fs::path& file, const truth::Truth& truth) {
  const CsvFile csv = read_csv(file);
  if (const auto columns = columns_of(truth); csv.header.cells != columns)
    throw BadInput(csv.header.place + ": the columns must be " + listed(columns));
  std::map<std::vector<double>, Known> rows;
  const std::size_t n = truth.inputs.size();
  for (const CsvRow& row : csv.rows) {
    std::vector<double> inputs;
    for (std::size_t i = 0; i < n; ++i) inputs.push_back(row.number(i));
    const double value = row.number(n + 1), error = row.number(n + 2);
    if (!std::ranges::all_of(inputs, [](double x) { return std::isfinite(x); }) || !std::isfinite(value) ||
        !std::isfinite(error) || !(error > 0))
      throw BadInput(row.place + ": inputs and value must be finite, error finite and positive");
    Known& known = rows[inputs];
    if (known.value.size() == truth.components.size())
      throw BadInput(row.place + ": a second row for these inputs");
    if (const std::string& name = truth.components[known.value.size()].name; row.cells[n] != name)
      throw BadInput(row.place + ": component " + row.cells[n] + " where " + name + " must be");
    known.value.push_back(value);
    known.error = std::max({known.error, error, std::abs(value) * 0x1p-53});
    known.source = "table " + file.filename().string();
  }
  for (const auto& [inputs, known] : rows)
    if (known.value.size() < truth.components.size())
      throw BadInput(file.string() + ": no row for component " + truth.components[known.value.size()].name +
                     " at " + listed(inputs));
  return rows;
}

const truth::Entry* maker_of(std::string_view table) {
  const auto& all = truth::registry();
  const auto found = std::ranges::find(all, table, &truth::Entry::name);
  return found == all.end() ? nullptr : &*found;
}

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Nothing is known yet: what would have to be done.
Known without_table(std::string_view name) {
  const std::string table(name);
  return {{no_number},
          no_number,
          "no table reference/" + table + ".csv: write reference/make/" + table +
              ".cpp and run build/release/make_reference reference " + table};
}

Known unknown(const truth::Truth& truth) {
  return {std::vector<double>(truth.components.size(), no_number), no_number, "nothing"};
}

Known on_the_spot(const std::string& table, const truth::Truth& truth, const std::vector<double>& inputs) {
  truth::Made made;
  try {
    made = truth::make_row(truth, inputs, truth::spot_digits);
  } catch (const std::exception& error) {
    throw BadInput("table " + table + " has no value at " + listed(inputs) + ": " + error.what());
  }
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
    const fs::path file = folder / (name + ".csv");
    if (!fs::exists(file))
      throw BadInput("cannot read " + file.string() + ": it is not there; build/release/make_reference " +
                     folder.string() + " " + name + " makes it");
    tables_.emplace(name, read(file, entry.make()));
  }
}

Known Reference::operator()(std::string_view name, const std::vector<double>& inputs) const {
  const auto table = tables_.find(name);
  const truth::Entry* maker = maker_of(name);
  if (maker && tables_.empty()) return unknown(maker->make());
  if (table == tables_.end() || !maker) return without_table(name);
  const auto& [file, rows] = *table;
  if (!std::ranges::all_of(inputs, [](double x) { return std::isfinite(x); }))
    throw BadInput("table " + file + " is asked at " + listed(inputs) + ": inputs must be finite");
  if (const auto row = rows.find(inputs); row != rows.end()) return row->second;
  const truth::Truth truth = maker->make();
  if (inputs.size() != truth.inputs.size())
    throw BadInput("table " + file + " takes " + std::to_string(truth.inputs.size()) + " inputs (" +
                   listed(truth.inputs) + "), not " + std::to_string(inputs.size()));
  return on_the_spot(file, truth, inputs);
}

}  // namespace oddity
