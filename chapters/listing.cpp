#include "chapters/listing.hpp"

#include <cctype>

namespace oddity {

bool mentions(std::string_view expression, std::string_view name) {
  const auto in_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (auto at = expression.find(name); at != std::string_view::npos; at = expression.find(name, at + 1)) {
    const auto end = at + name.size();
    if ((at == 0 || !in_word(expression[at - 1])) && (end == expression.size() || !in_word(expression[end])))
      return true;
  }
  return false;
}

std::string in_number_type(std::string_view expression, std::string_view number) {
  constexpr std::string_view old = "double";
  std::string text(expression);
  for (auto at = text.find(old); at != std::string::npos; at = text.find(old, at + number.size()))
    text.replace(at, old.size(), number);
  return text;
}

}  // namespace oddity
