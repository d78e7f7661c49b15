#include "report/markup.hpp"

#include <array>

#include "report/text_view.hpp"

namespace oddity {

std::string escaped(const std::string& text, bool in_cell) {
  std::string out;
  char within = 0;
  for (char c : text) {
    if (c == '$' || c == '`') {
      if (within == 0)
        within = c;
      else if (within == c)
        within = 0;
    }
    if (c == '\n' && in_cell) {
      out += ' ';
      continue;
    }
    const bool markup = within == 0 && (c == '*' || c == '_' || c == '<' || c == '~' || c == '[');
    if (markup || (c == '|' && in_cell)) out += '\\';
    out += c;
  }
  return out;
}

std::string code(const std::string& text) { return "`" + text + "`"; }

std::string with_powers(const std::string& text) {
  static constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool exponent = text[i] == 'e' && i > 0 && i + 2 < text.size() &&
                          std::isdigit(static_cast<unsigned char>(text[i - 1])) != 0 &&
                          (text[i + 1] == '-' || text[i + 1] == '+');
    if (!exponent) {
      out += text[i];
      continue;
    }
    out += text[i + 1] == '-' ? "×10⁻" : "×10";
    for (i += 2; i + 1 < text.size() && text[i] == '0';) ++i;
    for (; i < text.size() && std::isdigit(static_cast<unsigned char>(text[i])) != 0; ++i)
      out += digits[static_cast<std::size_t>(text[i] - '0')];
    --i;
  }
  return out;
}

std::string error_cell(double error) { return with_powers(shown_error(error)); }
std::string knob_cell(const TimedTrial& t) { return with_powers(shown_knob(t)); }
std::string value_cell(const Value& value, int digits) { return with_powers(shown(value, digits)); }

std::string table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
                  const std::string& right) {
  const auto line = [](const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) text += " " + cell + " |";
    return text + "\n";
  };
  std::string text = line(header) + "|";
  for (std::size_t i = 0; i < header.size(); ++i)
    text += right.find(static_cast<char>('0' + i)) == std::string::npos ? " --- |" : " ---: |";
  text += "\n";
  for (const auto& row : rows) text += line(row);
  return text + "\n";
}

}  // namespace oddity
