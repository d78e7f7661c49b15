#pragma once

#include <string>

namespace oddity {

/// Text of the exercises as a terminal or a chart's title can show it: $formulas$ in signs of Unicode, `code`
/// without its marks. "$\dot\theta^2\le\frac12\sqrt{g/L}$" is "θ'² ≤ (1/2)√(g/L)".
std::string readable(const std::string& text);

}  // namespace oddity
