#include "report/text/visible.hpp"

#include <algorithm>

namespace oddity {

namespace {

unsigned char byte_at(std::string_view text, std::size_t at) {
  return at < text.size() ? static_cast<unsigned char>(text[at]) : 0;
}

/// Whether the text begins with a bidirectional control [Unicode's Bidi_Control], which would change the
/// order in which text is shown.
bool turns_direction(std::string_view text) {
  constexpr std::string_view marks[]{"\u061c", "\u200e", "\u200f", "\u202a", "\u202b", "\u202c",
                                     "\u202d", "\u202e", "\u2066", "\u2067", "\u2068", "\u2069"};
  return std::ranges::any_of(marks, [&](std::string_view mark) { return text.starts_with(mark); });
}

/// Size in bytes of the first character; 0 for control characters and bytes that are not UTF-8.
std::size_t letter_size(std::string_view text) {
  const unsigned char first = byte_at(text, 0);
  if (first < 0x80) return (first >= 0x20 && first != 0x7f) || first == '\n' || first == '\t' ? 1 : 0;
  const std::size_t size = first >= 0xc2 && first < 0xe0   ? 2
                           : first >= 0xe0 && first < 0xf0 ? 3
                           : first >= 0xf0 && first < 0xf5 ? 4
                                                           : 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((byte_at(text, i) & 0xc0) != 0x80) return 0;
  const bool control = first == 0xc2 && byte_at(text, 1) < 0xa0;
  const bool too_long =
      (first == 0xe0 && byte_at(text, 1) < 0xa0) || (first == 0xf0 && byte_at(text, 1) < 0x90);
  return control || too_long || turns_direction(text) ? 0 : size;
}

/// Size in bytes of a change of colour, "\x1b[0;31m", at the start of the text; 0 otherwise.
std::size_t colour_size(std::string_view text) {
  if (!text.starts_with("\x1b[")) return 0;
  const std::size_t end = text.find('m');
  if (end == std::string_view::npos || end > 8) return 0;
  for (std::size_t from = 2; from <= end;) {
    const std::size_t to = std::min(text.find(';', from), end);
    const std::string_view code = text.substr(from, to - from);
    const bool known =
        code == "0" || code == "1" || code == "2" ||
        (code.size() == 2 && (code[0] == '3' || code[0] == '9') && code[1] >= '0' && code[1] <= '7');
    if (!known) return 0;
    from = to + 1;
  }
  return end + 1;
}

/// Replaces bytes that are not printable by "\xNN". `passed` returns the number of bytes to keep in any case.
template <class Passed>
std::string shown_but(std::string_view text, const Passed& passed) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string all;
  while (!text.empty()) {
    const std::size_t size = std::max(letter_size(text), passed(text));
    if (size > 0)
      all += text.substr(0, size);
    else
      (all += "\\x") += {digits[byte_at(text, 0) / 16], digits[byte_at(text, 0) % 16]};
    text.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return all;
}

}  // namespace

std::string visible(std::string_view text) {
  return shown_but(text, [](std::string_view) { return std::size_t(0); });
}

VisibleOutput::VisibleOutput(std::ostream& stream, bool colours, std::string_view also)
    : stream_(stream), to_(stream.rdbuf()), colours_(colours), also_(also) {
  stream.rdbuf(this);
}

VisibleOutput::~VisibleOutput() {
  sync();
  const auto state = stream_.rdstate();
  stream_.rdbuf(to_);  // clears the state
  stream_.clear(state);
}

bool VisibleOutput::send(std::size_t size) {
  const std::string text = shown_but(std::string_view(line_).substr(0, size), [&](std::string_view rest) {
    if (also_.find(rest[0]) != std::string_view::npos) return std::size_t(1);
    return colours_ ? colour_size(rest) : 0;
  });
  line_.erase(0, size);
  return to_->sputn(text.data(), static_cast<std::streamsize>(text.size())) ==
         static_cast<std::streamsize>(text.size());
}

VisibleOutput::int_type VisibleOutput::overflow(int_type c) {
  const char one = traits_type::to_char_type(c);
  return !traits_type::eq_int_type(c, traits_type::eof()) && xsputn(&one, 1) == 1 ? c : traits_type::eof();
}

std::streamsize VisibleOutput::xsputn(const char* text, std::streamsize size) {
  const std::lock_guard lock(mutex_);
  const std::string_view more(text, static_cast<std::size_t>(size));
  const std::size_t before = line_.size(), end = more.rfind('\n');
  line_ += more;
  return end == std::string_view::npos || send(before + end + 1) ? size : 0;
}

int VisibleOutput::sync() {
  const std::lock_guard lock(mutex_);
  return send(line_.size()) && to_->pubsync() == 0 ? 0 : -1;
}

}  // namespace oddity
