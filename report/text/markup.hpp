#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Text within markup: Markdown for the pages, and escapes for HTML and SVG.
namespace oddity {

/// Text for XML or HTML: & < > " become references, control characters blanks.
std::string in_xml(std::string_view text);

/// Text for a table cell or a paragraph, in one line. Escapes Markdown's markup except $formulas$ and `code`.
/// A formula becomes $`...`$, as Markdown would remove some of its backslashes.
std::string escaped(const std::string& text, bool in_cell = true);
/// As escaped(), for a paragraph that may contain *emphasis*.
std::string prose(const std::string& text);
std::string code(const std::string& text);
/// A name that is safe in a path and in a link: any character except letters, digits, dots and dashes becomes
/// an underscore.
std::string file_name(const std::string& text);
/// Typeset powers of ten, which do not break at the end of a line: "4.4×10⁻¹⁶".
std::string with_powers(const std::string& text);
/// A typeset unit: "m/s^2" becomes "m/s²", "sqrt(L/2g)" becomes "√(L/2g)".
std::string typeset_unit(std::string_view unit);

/// A Markdown table. Bars in cells are escaped. `right` lists the columns of numbers, by their digit from 0,
/// which are aligned to the right.
std::string table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
                  const std::string& right = "");

}  // namespace oddity
