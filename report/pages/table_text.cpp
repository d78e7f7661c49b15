#include "report/pages/table_text.hpp"

#include <nlohmann/json.hpp>

#include "reference/text.hpp"

namespace oddity {

namespace {

struct CsvCell {
  std::string operator()(double x) const { return shortest(x); }
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

}  // namespace

std::string to_csv(const Table& table) {
  std::string text = csv_line(table.columns, CsvCell());
  for (const auto& row : table.rows)
    text += csv_line(row, [](const Cell& cell) { return std::visit(CsvCell(), cell); });
  return text;
}

std::string to_json(const Table& table) {
  using Json = nlohmann::ordered_json;  // writes what is not finite as null
  Json rows = Json::array();
  for (const auto& row : table.rows) {
    Json& object = rows.emplace_back(Json::object());
    for (std::size_t i = 0; i < row.size(); ++i)
      object[table.columns[i]] = std::visit([](const auto& x) { return Json(x); }, row[i]);
  }
  return rows.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace oddity
