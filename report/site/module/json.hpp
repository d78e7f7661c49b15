#pragma once

#include <string>
#include <string_view>

/// Functions exported to the page, and texts as JSON.
#define ODDITY_EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace oddity::module {

inline std::string quoted(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < ' ') {
      quoted += std::string("\\u00") + digits[code / 16] + digits[code % 16];
      continue;
    }
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

inline std::string flag(bool yes) { return yes ? "true" : "false"; }

template <class Range, class Text>
std::string listed(const Range& range, const Text& text) {
  std::string all;
  for (const auto& entry : range) all += (all.empty() ? "" : ",") + text(entry);
  return '[' + all + ']';
}

}  // namespace oddity::module
