#include "report/text/readable.hpp"

#include <string_view>

#include "formula/parse.hpp"
#include "formula/shown.hpp"

namespace oddity {

namespace {

/// The text with its formulas printed and without the marks of `code`. An unreadable formula keeps its
/// source.
template <class Print>
std::string with_formulas(std::string_view text, const Print& print) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const auto end = c == '$' || c == '`' ? text.find(c, i + 1) : std::string_view::npos;
    if (end == std::string_view::npos || end == i + 1) {
      out += c;
      continue;
    }
    const std::string_view inside = text.substr(i + 1, end - i - 1);
    try {
      out += c == '$' ? print(formula::parse_shown(inside)) : std::string(inside);
    } catch (const formula::Unreadable&) {
      out += inside;
    }
    i = end;
  }
  return out;
}

}  // namespace

std::string readable(const std::string& text) {
  return with_formulas(text, [](const formula::Tree& tree) { return formula::unicode(tree); });
}

std::optional<std::pair<std::string, std::string>> formulas_that_differ(const std::string& a,
                                                                        const std::string& b,
                                                                        const formula::Marks& in_a,
                                                                        const formula::Marks& in_b) {
  if (a == b || !formula::is_formula(a) || !formula::is_formula(b)) return std::nullopt;
  const auto tree = [](const std::string& text) {
    return formula::parse_shown(std::string_view(text).substr(1, text.size() - 2));
  };
  try {
    const auto [left, right] = formula::with_differences_marked(tree(a), tree(b));
    return std::pair(formula::unicode(left, in_a), formula::unicode(right, in_b));
  } catch (const formula::Unreadable&) {
    return std::nullopt;
  }
}

std::string typed(std::string_view text) { return with_formulas(text, formula::plain); }

}  // namespace oddity
