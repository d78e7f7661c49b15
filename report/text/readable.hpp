#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "formula/print.hpp"

namespace oddity {

/// Text of the exercises for a terminal or a chart's title: $formulas$ in Unicode, `code` without its marks.
/// "$\dot\theta^2\le\frac12\sqrt{g/L}$" becomes "θ'² ≤ (1/2)√(g/L)".
std::string readable(const std::string& text);
/// Two formulas with marks around the places where they differ; nullopt if the texts are equal or not both
/// one formula.
std::optional<std::pair<std::string, std::string>> formulas_that_differ(const std::string&,
                                                                        const std::string&,
                                                                        const formula::Marks&,
                                                                        const formula::Marks&);
/// Formulas as one types them: "theta'^2 <= (1/2) sqrt(g/L)".
std::string typed(std::string_view text);

}  // namespace oddity
