#pragma once

#include <string>
#include <string_view>

/// Makes any text safe for a place in code.
namespace oddity {

inline bool is_control(char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }

/// For the end of a line comment: on one line, and without a backslash at its end, which would continue the
/// comment on the next line.
inline std::string in_comment(std::string text) {
  for (char& c : text)
    if (is_control(c)) c = ' ';
  text.erase(text.find_last_not_of(' ') + 1);
  return text.ends_with('\\') ? text + '.' : text;
}

/// For a string literal, also as printf's format.
inline std::string in_string(std::string text) {
  for (char& c : text)
    if (is_control(c) || std::string_view("\"\\%$").find(c) != std::string_view::npos) c = '_';
  return text;
}

}  // namespace oddity
