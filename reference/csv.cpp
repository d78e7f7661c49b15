#include "reference/csv.hpp"

#include <algorithm>
#include <boost/algorithm/string/join.hpp>
#include <boost/tokenizer.hpp>
#include <set>
#include <sstream>

#include "reference/bad_input.hpp"
#include "reference/files.hpp"
#include "reference/text.hpp"

namespace oddity {

double CsvRow::number(std::size_t i) const {
  if (const auto x = parse_number(cells[i])) return *x;
  throw BadInput(place + ": '" + cells[i] + "' in column " + std::to_string(i + 1) + " is not a number");
}

namespace {

/// Whether a quotation mark is left open, which Boost's tokenizer accepts.
bool quote_is_open(const std::string& line) {
  bool open = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\\')
      ++i;
    else if (line[i] == '"')
      open = !open;
  }
  return open;
}

std::vector<std::string> split(const std::string& line, const std::string& place) {
  using Separator = boost::escaped_list_separator<char>;
  if (quote_is_open(line)) throw BadInput(place + ": not a line of CSV: a quotation mark is not closed");
  try {
    const boost::tokenizer<Separator> cells(line, Separator());
    return {cells.begin(), cells.end()};
  } catch (const boost::escaped_list_error& error) {
    throw BadInput(place + ": not a line of CSV: " + error.what());
  }
}

}  // namespace

CsvFile read_csv(const std::filesystem::path& file) {
  std::istringstream in(read_whole(file));
  CsvFile csv;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty() || line.starts_with('#')) continue;
    const std::string place = file.string() + ":" + std::to_string(number);
    if (std::ranges::any_of(line, [](unsigned char c) { return c < 0x20 || c == 0x7f; }))
      throw BadInput(place + ": not a line of CSV: it holds a control character");
    CsvRow row{place, split(line, place)};
    if (csv.header.cells.empty())
      csv.header = std::move(row);
    else if (row.cells.size() == csv.header.cells.size())
      csv.rows.push_back(std::move(row));
    else
      throw BadInput(place + ": " + std::to_string(row.cells.size()) + " cells where the header has " +
                     std::to_string(csv.header.cells.size()));
  }
  if (csv.rows.empty()) throw BadInput(file.string() + ": the table has no rows");
  return csv;
}

std::vector<CsvRow> read_rows(const std::filesystem::path& file, const std::vector<std::string>& columns,
                              std::size_t keys) {
  CsvFile csv = read_csv(file);
  if (csv.header.cells != columns)
    throw BadInput(csv.header.place + ": the columns must be " + boost::algorithm::join(columns, ","));
  std::set<std::vector<std::string>> seen;
  for (const CsvRow& row : csv.rows) {
    const std::vector<std::string> key(row.cells.begin(),
                                       row.cells.begin() + static_cast<std::ptrdiff_t>(keys));
    if (!seen.insert(key).second)
      throw BadInput(row.place + ": a second row for " + boost::algorithm::join(key, ", "));
  }
  return std::move(csv.rows);
}

std::string csv_cell(const std::string& text) {
  if (text.find_first_of(",\"\\") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

}  // namespace oddity
