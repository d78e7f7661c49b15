#include "report/text/screen.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string_view>

#include "reference/text.hpp"

namespace oddity {

namespace {

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

bool coloured(bool terminal) {
  if (!environment("NO_COLOR").empty()) return false;
  const std::string_view forced = environment("CLICOLOR_FORCE");
  if (!forced.empty() && forced != "0") return true;
  return terminal && environment("TERM") != "dumb";
}

std::size_t width_of_terminal(int descriptor) {
  const auto asked = parse_number(environment("COLUMNS"));
  if (asked && *asked >= 1 && *asked < 1e4) return static_cast<std::size_t>(*asked);
  winsize size{};
  if (ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
  return 80;
}

constexpr std::string_view escape = "\x1b[", reset = "\x1b[0m";

/// One piece of a text: a character with its accents, or a change of colour.
struct Piece {
  std::string_view bytes;
  std::size_t columns;
};

bool is_continued(char c) { return (c & 0xC0) == 0x80; }

/// Whether the text begins with a combining accent (U+0300 to U+036F).
bool is_accent(std::string_view text) {
  return text.starts_with('\xCC') || (text.size() > 1 && text[0] == '\xCD' && text[1] <= '\xAF');
}

Piece first_of(std::string_view text) {
  if (text.starts_with(escape)) return {text.substr(0, text.find('m') + 1), 0};
  std::size_t size = 1;
  while (size < text.size() && (is_continued(text[size]) || is_accent(text.substr(size)))) ++size;
  return {text.substr(0, size), 1};
}

/// As many characters as fit, and all changes of colour.
std::string first_columns(std::string_view text, std::size_t columns) {
  std::string kept;
  while (!text.empty()) {
    const Piece piece = first_of(text);
    text.remove_prefix(piece.bytes.size());
    if (piece.columns > columns) {
      columns = 0;
      continue;
    }
    kept += piece.bytes;
    columns -= piece.columns;
  }
  return kept;
}

}  // namespace

std::string Screen::styled(Style style, const std::string& text) const {
  constexpr std::string_view codes[] = {"1", "32", "33", "31", "2"};
  if (!colour || text.empty()) return text;
  return std::string(escape) + std::string(codes[static_cast<std::size_t>(style)]) + "m" + text +
         std::string(reset);
}

Screen screen_of(int descriptor) {
  const bool terminal = isatty(descriptor) != 0;
  return {terminal ? width_of_terminal(descriptor) : 0, coloured(terminal)};
}

std::size_t columns_of(const std::string& text) {
  std::size_t columns = 0;
  for (std::string_view left = text; !left.empty();) {
    const Piece piece = first_of(left);
    columns += piece.columns;
    left.remove_prefix(piece.bytes.size());
  }
  return columns;
}

std::string cut(const std::string& text, std::size_t columns) {
  if (columns_of(text) <= columns) return text;
  return first_columns(text, columns - std::min<std::size_t>(columns, 3)) +
         std::string(std::min<std::size_t>(columns, 3), '.');
}

std::string cut_at_word(const std::string& text, std::size_t columns) {
  if (columns_of(text) <= columns || columns < 4) return cut(text, columns);
  std::string kept = first_columns(text, columns - 3);
  const bool between_words = text[kept.size()] == ' ';
  const std::size_t blank = kept.find_last_of(' ');
  if (!between_words && blank != std::string::npos && blank > kept.size() / 2) kept.resize(blank);
  kept.resize(kept.find_last_not_of(" ,;:") + 1);
  return kept + "...";
}

std::string wrapped(const std::string& text, const Screen& screen, std::size_t indent) {
  if (screen.width == 0) return text;
  std::istringstream lines(text);
  std::string all;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
    std::string out = line.substr(0, begin);
    std::size_t column = begin;
    std::istringstream words(line.substr(begin));
    for (std::string word; std::getline(words, word, ' ');) {
      const std::size_t size = columns_of(word);
      const bool first = column == begin && out.size() == begin;
      if (!first && column + 1 + size > screen.width) {
        out += "\n" + std::string(indent, ' ');
        column = indent;
      } else if (!first) {
        out += ' ';
        ++column;
      }
      out += word;
      column += size;
    }
    all += out + "\n";
  }
  if (!text.ends_with('\n') && !all.empty()) all.pop_back();
  return all;
}

}  // namespace oddity
