#pragma once

#include <string>
#include <string_view>
#include <utility>

/// Formulas in the site's pages: TeX as MathML.
namespace oddity::html {

/// What is no formula stays as TeX in <code class="tex">.
std::string formula(std::string_view tex);
/// As it is read: with brackets around each operand.
std::string formula_in_all_brackets(std::string_view tex);
/// Both with the places marked in which they differ, by class="differs".
std::pair<std::string, std::string> formulas_that_differ(std::string_view, std::string_view);

}  // namespace oddity::html
