#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <string_view>

namespace oddity {

/// The shortest decimal that reads back as the same double ("inf", "nan" included).
inline std::string format_shortest(double x) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x).ptr;
  return {buffer, end};
}

/// `digits` significant digits, in the shorter of fixed and scientific notation.
inline std::string format_significant(double x, int digits) {
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::general, digits).ptr;
  return {buffer, end};
}

/// The whole text as a number; empty for anything else. A leading '+' is accepted.
inline std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  double x{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return x;
}

}  // namespace oddity
