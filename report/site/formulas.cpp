#include "report/site/formulas.hpp"

#include "formula/print.hpp"
#include "formula/shown.hpp"
#include "report/site/page.hpp"
#include "report/text/markup.hpp"

namespace oddity::html {

namespace {

template <class Change>
std::string shown(std::string_view tex, const Change& change) {
  try {
    return formula::mathml_in_pieces(change(formula::parse_shown(tex)));
  } catch (const formula::Unreadable&) {
    return element("code", " class=\"tex\"", in_xml(tex));
  }
}

}  // namespace

std::string formula(std::string_view tex) {
  return shown(tex, [](const formula::Tree& tree) { return tree; });
}

std::string formula_in_all_brackets(std::string_view tex) { return shown(tex, formula::with_all_brackets); }

std::pair<std::string, std::string> formulas_that_differ(std::string_view a, std::string_view b) {
  try {
    const auto [left, right] =
        formula::with_differences_marked(formula::parse_shown(a), formula::parse_shown(b));
    return {formula::mathml_in_pieces(left), formula::mathml_in_pieces(right)};
  } catch (const formula::Unreadable&) {
    return {formula(a), formula(b)};
  }
}

}  // namespace oddity::html
