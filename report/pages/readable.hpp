#pragma once

#include <string>

namespace oddity {

/// Text of the exercises as a terminal can show it: $formulas$ in letters and signs, `code` without its
/// marks. "$\sqrt{L/2g}$" is "√(L/2g)", "$\dot\theta_0=30^\circ$" is "θ'₀=30°".
std::string readable(const std::string& text);

}  // namespace oddity
