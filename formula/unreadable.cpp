#include "formula/unreadable.hpp"

#include <algorithm>

namespace oddity::formula {

namespace {

/// The text around the place in one line, and a caret below it.
std::string shown(std::string_view text, std::size_t place, const std::string& reason) {
  constexpr std::size_t before = 60, after = 30;
  const std::size_t begin = place > before ? place - before : 0;
  const std::size_t end = std::min(text.size(), place + after);
  std::string line(text.substr(begin, end - begin));
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  // Bytes that continue a character take no column.
  const auto columns = std::ranges::count_if(text.substr(begin, place - begin), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  });
  return "cannot read this formula:\n  " + (begin > 0 ? "..." + line : line) + "\n  " +
         std::string(static_cast<std::size_t>(columns) + (begin > 0 ? 3 : 0), ' ') + "^ " + reason;
}

}  // namespace

Unreadable::Unreadable(std::string_view text, std::size_t place, std::string reason)
    : std::invalid_argument(shown(text, std::min(place, text.size()), reason)),
      place_(std::min(place, text.size())),
      reason_(std::move(reason)) {}

}  // namespace oddity::formula
