#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "formula/print.hpp"

namespace oddity {

/// Text of the exercises as a terminal or a chart's title can show it: $formulas$ in signs of Unicode, `code`
/// without its marks. "$\dot\theta^2\le\frac12\sqrt{g/L}$" is "θ'² ≤ (1/2)√(g/L)".
std::string readable(const std::string& text);
/// Two texts, each of one formula, with marks around the places in which they differ; nothing of others.
std::optional<std::pair<std::string, std::string>> formulas_that_differ(const std::string&,
                                                                        const std::string&,
                                                                        const formula::Marks&,
                                                                        const formula::Marks&);
/// As one types it: "theta'^2 <= (1/2) sqrt(g/L)".
std::string typed(std::string_view text);

}  // namespace oddity
