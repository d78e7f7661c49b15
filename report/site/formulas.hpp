#pragma once

#include <string>
#include <string_view>
#include <utility>

/// Formulas on the site's pages: TeX as MathML.
namespace oddity::html {

/// Anything else stays as TeX in <code class="tex">.
std::string formula(std::string_view tex);
/// With brackets around each operand, to show how it was read.
std::string formula_in_all_brackets(std::string_view tex);
/// Both formulas, with their differences marked by class="differs".
std::pair<std::string, std::string> formulas_that_differ(std::string_view, std::string_view);

}  // namespace oddity::html
