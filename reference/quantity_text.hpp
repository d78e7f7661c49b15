#pragma once

#include <string_view>

namespace oddity {

/// The text as a number in `unit`: "0.5", "30deg", "5 us", "9.81 m/s^2", "9.81m/s2". A number without a unit
/// is in `unit` already. Units are m, s, g, N, J, W, Hz and rad with the prefixes p to G; min, h, d, yr
/// (365.25 days), AU, deg, rpm, "solar mass", bins; and their products, quotients and powers. Throws
/// BadInput, with the units that fit, when the text is no number or its unit measures something else.
double in_unit(std::string_view text, std::string_view unit);

}  // namespace oddity
