#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Text within markup: Markdown that the pages share, and what HTML and SVG need.
namespace oddity {

/// Text as it stands, in XML or HTML: & < > " become references, and control characters blanks.
std::string in_xml(std::string_view text);

/// Text for a table cell or a paragraph, in one line: what Markdown would take for markup is escaped, except
/// $formulas$ and `code`. A formula is written as $`...`$, as Markdown would take away some of its
/// backslashes.
std::string escaped(const std::string& text, bool in_cell = true);
/// The same for a paragraph of ours, in which *emphasis* is meant.
std::string prose(const std::string& text);
std::string code(const std::string& text);
/// A name that is safe in a path and in a link: what is no letter, digit, dot or dash becomes an underscore.
std::string file_name(const std::string& text);
/// Powers of ten as readers write them, which also do not break over a line's end: "4.4×10⁻¹⁶".
std::string with_powers(const std::string& text);
/// A unit as it is printed: "m/s²" of "m/s^2", "√(L/2g)" of "sqrt(L/2g)".
std::string typeset_unit(std::string_view unit);

/// Cells are in one line, and no bar in them ends them. A column whose place (from 0) is among the digits of
/// `right` holds numbers and is set to the right.
std::string table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
                  const std::string& right = "");

}  // namespace oddity
