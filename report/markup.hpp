#pragma once

#include <string>
#include <vector>

#include "report/results.hpp"

/// Pieces of Markdown that the pages share.
namespace oddity {

/// Text for a table cell or a paragraph: what Markdown would take for markup is escaped, except within $math$
/// and `code`; a bar always, as a cell would end at it.
std::string escaped(const std::string& text, bool in_cell = true);
std::string code(const std::string& text);
/// Powers of ten as readers write them, which also do not break over a line's end: "4.4×10⁻¹⁶".
std::string with_powers(const std::string& text);

std::string error_cell(double error);
std::string knob_cell(const TimedTrial& t);
std::string value_cell(const Value& value, int digits);

/// A column whose place (from 0) is among the digits of `right` holds numbers and is set to the right.
std::string table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
                  const std::string& right = "");

}  // namespace oddity
