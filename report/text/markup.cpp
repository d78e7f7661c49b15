#include "report/text/markup.hpp"

#include <array>
#include <cctype>

namespace oddity {

namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A digit or a minus as a superscript.
std::string raised(char c) {
  static constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  return c == '-' ? "⁻" : digits[static_cast<std::size_t>(c - '0')];
}

/// A formula in GitHub's form $`...`$, in which Markdown leaves backslashes alone. In a cell, bars become
/// \vert or \Vert, as a bar would end the cell.
std::string formula(std::string_view tex, bool in_cell) {
  std::string out = "$`";
  for (std::size_t i = 0; i < tex.size(); ++i) {
    const bool pair = tex[i] == '\\' && i + 1 < tex.size();
    if (in_cell && pair && tex[i + 1] == '|')
      out += "\\Vert ", ++i;
    else if (pair)
      out += {tex[i], tex[i + 1]}, ++i;
    else if (in_cell && tex[i] == '|')
      out += "\\vert ";
    else
      out += is_control(tex[i]) || tex[i] == '`' ? ' ' : tex[i];
  }
  return out + "`$";
}

/// Keeps $formulas$ and `code`; escapes the characters in `markup` in all other text.
std::string marked_up(std::string_view text, std::string_view markup, bool in_cell) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const auto end = c == '$' || c == '`' ? text.find(c, i + 1) : std::string_view::npos;
    if (end != std::string_view::npos && end > i + 1) {
      const std::string_view inside = text.substr(i + 1, end - i - 1);
      out += c == '$' ? formula(inside, in_cell) : code(std::string(inside));
      i = end;
    } else if (c == ' ' || is_control(c)) {
      if (!out.empty()) out += ' ';
    } else {
      const bool begins_a_block = out.empty() &&
                                  std::string_view("#>-+=").find(c) != std::string_view::npos &&
                                  (c == '#' || c == '>' || text.substr(i + 1, 1) == " ");
      if (begins_a_block || markup.find(c) != std::string_view::npos || (c == '|' && in_cell)) out += '\\';
      out += c;
    }
  }
  return out;
}

/// The text in one line, with unescaped bars escaped.
std::string as_cell(const std::string& text) {
  std::string out;
  std::size_t backslashes = 0;
  for (char c : text) {
    if (c == '|' && backslashes % 2 == 0) out += '\\';
    backslashes = c == '\\' ? backslashes + 1 : 0;
    out += is_control(c) ? ' ' : c;
  }
  return out;
}

}  // namespace

std::string in_xml(std::string_view text) {
  std::string safe;
  for (char c : text)
    safe += c == '&'   ? "&amp;"
            : c == '<' ? "&lt;"
            : c == '>' ? "&gt;"
            : c == '"' ? "&quot;"
                       : std::string(1, is_control(c) ? ' ' : c);
  return safe;
}

std::string escaped(const std::string& text, bool in_cell) { return marked_up(text, "\\`$*_<&~[]", in_cell); }

std::string prose(const std::string& text) { return marked_up(text, "\\`$_<&~[]", false); }

std::string code(const std::string& text) {
  std::string inside, fence = "`";
  for (char c : text) inside += is_control(c) ? ' ' : c;
  while (inside.find(fence) != std::string::npos) fence += '`';
  const bool apart = fence.size() > 1;
  return fence + (apart ? " " : "") + inside + (apart ? " " : "") + fence;
}

std::string file_name(const std::string& text) {
  std::string name;
  for (char c : text)
    name +=
        std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || (c == '.' && !name.empty()) ? c : '_';
  return name.substr(0, 100);
}

std::string with_powers(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool exponent = text[i] == 'e' && i > 0 && i + 2 < text.size() && is_digit(text[i - 1]) &&
                          (text[i + 1] == '-' || text[i + 1] == '+');
    if (!exponent) {
      out += text[i];
      continue;
    }
    out += text[i + 1] == '-' ? "×10⁻" : "×10";
    for (i += 2; i + 1 < text.size() && text[i] == '0';) ++i;
    for (; i < text.size() && is_digit(text[i]); ++i) out += raised(text[i]);
    --i;
  }
  return out;
}

std::string typeset_unit(std::string_view unit) {
  std::string out;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (unit.substr(i).starts_with("sqrt")) {
      out += "√";
      i += 3;
    } else if (unit[i] == '^') {
      for (; i + 1 < unit.size() && (is_digit(unit[i + 1]) || unit[i + 1] == '-'); ++i)
        out += raised(unit[i + 1]);
    } else {
      out += unit[i];
    }
  }
  return out;
}

std::string table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
                  const std::string& right) {
  const auto line = [](const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) text += " " + as_cell(cell) + " |";
    return text + "\n";
  };
  std::string text = line(header) + "|";
  for (std::size_t i = 0; i < header.size(); ++i)
    text += right.find(static_cast<char>('0' + i)) == std::string::npos ? "---|" : "---:|";
  text += "\n";
  for (const auto& row : rows) text += line(row);
  return text + "\n";
}

}  // namespace oddity
