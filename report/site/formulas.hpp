#pragma once

#include <map>
#include <string>
#include <string_view>

/// Formulas in the site's pages, typeset when the site is written: TeX as MathML, by KaTeX.
namespace oddity::html {

/// A formula as it stands in a page until it is typeset.
std::string marked(std::string_view tex);

/// Replaces the marked formulas of all pages, each distinct one typeset once, by the `katex` that is
/// installed; without it they stay as TeX in <code class="tex">. Returns whether they are typeset. Throws
/// std::runtime_error naming a formula that KaTeX refuses.
bool typeset(std::map<std::string, std::string>& pages);

}  // namespace oddity::html
