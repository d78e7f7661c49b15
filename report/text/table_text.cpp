#include "report/text/table_text.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reference/text.hpp"

namespace oddity {

namespace {

struct CsvCell {
  std::string operator()(double x) const { return format_shortest(x); }
  std::string operator()(long n) const { return std::to_string(n); }
  std::string operator()(const std::string& text) const {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string out = "\"";
    for (char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
    return out + "\"";
  }
};

std::string csv_line(const auto& cells, const auto& shown) {
  std::string line;
  for (const auto& cell : cells) line += (&cell == cells.data() ? "" : ",") + shown(cell);
  return line + "\n";
}

using Rows = std::vector<std::vector<std::string>>;

constexpr std::size_t indent = 2, between = 2;

/// Widths of the columns; a row of one cell belongs to none.
std::vector<std::size_t> widths_of(const Rows& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows)
    for (std::size_t i = 0; row.size() > 1 && i < row.size(); ++i) {
      if (widths.size() <= i) widths.push_back(0);
      widths[i] = std::max(widths[i], columns_of(row[i]));
    }
  return widths;
}

/// The least width of a column that may be shortened: enough for a name or the beginning of a sentence.
std::size_t least_of(std::size_t width) { return std::clamp<std::size_t>(width / 4, 14, 20); }

std::size_t total(const std::vector<std::size_t>& widths) {
  std::size_t sum = indent;
  for (std::size_t width : widths) sum += width + between;
  return widths.empty() ? 0 : sum - between;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

/// Widths that fit the screen. Only columns in `shorten` shrink, always the widest of them first.
std::vector<std::size_t> fitted(const std::vector<std::size_t>& natural, const Rows& rows,
                                const Screen& screen, const Fitting& fit) {
  std::vector<std::size_t> widths = natural;
  while (total(widths) > screen.width) {
    std::size_t* widest = nullptr;
    for (std::size_t i = 0; i < widths.size(); ++i)
      if (contains(fit.shorten, rows.front()[i]) && widths[i] > least_of(natural[i]) &&
          (!widest || widths[i] > *widest))
        widest = &widths[i];
    if (!widest) break;
    --*widest;
  }
  return widths;
}

void remove_column(Rows& rows, std::size_t column) {
  for (auto& row : rows)
    if (column < row.size()) row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
}

/// Moves the first column's values to separate lines above their rows.
void set_first_above(Rows& rows, const Screen& screen) {
  Rows all;
  std::string above;
  for (auto& row : rows) {
    const std::string first = row.front();
    row.erase(row.begin());
    const bool heading = &row == &rows.front();
    if (!heading && !first.empty() && first != above)
      all.push_back({screen.styled(Style::heading, first) + ":"});
    if (!heading) row.front().insert(0, "  ");
    if (!first.empty()) above = first;
    all.push_back(std::move(row));
  }
  rows = std::move(all);
}

/// Leaves columns out until the others fit, and returns their names.
std::string leave_out(Rows& rows, const Screen& screen, const Fitting& fit) {
  std::string names;
  for (const std::string& name : fit.leave_out) {
    if (total(fitted(widths_of(rows), rows, screen, fit)) <= screen.width) break;
    const auto column = std::ranges::find(rows.front(), name);
    if (column == rows.front().end()) continue;
    remove_column(rows, static_cast<std::size_t>(column - rows.front().begin()));
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

std::string line_of(const std::vector<std::string>& row, const std::vector<std::size_t>& widths,
                    const Screen& screen) {
  if (row.size() == 1) return cut(row.front(), screen.at_most(indent + columns_of(row.front())) - indent);
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::string cell = cut(row[i], widths[i]);
    line += cell + std::string(widths[i] - columns_of(cell) + between, ' ');
  }
  line.resize(line.find_last_not_of(' ') + 1);
  return line;
}

}  // namespace

std::string aligned(Rows rows, const Screen& screen, const Fitting& fit) {
  if (rows.empty()) return "";
  const bool heading = !fit.shorten.empty() || !fit.leave_out.empty();
  const bool fits = !heading || screen.width == 0 || total(widths_of(rows)) <= screen.width;
  if (!fits && fit.first_above) set_first_above(rows, screen);
  const std::string without = fits ? "" : leave_out(rows, screen, fit);
  const auto widths = fits ? widths_of(rows) : fitted(widths_of(rows), rows, screen, fit);
  std::string text;
  for (const auto& row : rows) {
    const std::string line = line_of(row, widths, screen);
    text += std::string(indent, ' ') +
            (heading && &row == &rows.front() ? screen.styled(Style::heading, line) : line) + "\n";
  }
  if (!without.empty()) text += wrapped("  (too wide for this screen: " + without + ")\n", screen, indent);
  return text;
}

std::string to_csv(const Table& table) {
  std::string text = csv_line(table.columns, CsvCell());
  for (const auto& row : table.rows)
    text += csv_line(row, [](const Cell& cell) { return std::visit(CsvCell(), cell); });
  return text;
}

std::string to_json(const Table& table) {
  using Json = nlohmann::ordered_json;  // writes numbers that are not finite as null
  Json rows = Json::array();
  for (const auto& row : table.rows) {
    Json& object = rows.emplace_back(Json::object());
    for (std::size_t i = 0; i < row.size(); ++i)
      object[table.columns[i]] = std::visit([](const auto& x) { return Json(x); }, row[i]);
  }
  return rows.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace oddity
