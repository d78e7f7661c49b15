#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace oddity {

/// The text as a number in `unit`: "0.5", "30deg", "5 us", "9.81 m/s^2", "9.81m/s2". A number without a unit
/// is in `unit` already. Units are m, s, g, A, N, J, W, Pa, V, Ohm, H, Hz and rad with the prefixes p to G.
/// Others are min, h, d, yr (365.25 days), AU, deg, rpm, "solar mass", bins and %. Products, quotients and
/// powers of units are units. Throws BadInput if the text is not a number, or, with the units that fit, if
/// its unit measures something else.
double in_unit(std::string_view text, std::string_view unit);

/// Size of a unit in its base units, and the powers of m, s, kg, A, rad, solar mass and bins in it.
struct UnitText {
  long double size;
  std::array<int, 7> powers;
};
/// Empty if the text is not a unit.
std::optional<UnitText> unit_of(std::string_view text);

/// Whether in_unit accepts this as a unit; empty: pure numbers.
bool is_unit(std::string_view text);
/// The usual units that fit, by their names, with the size of each in `unit`.
std::vector<std::pair<std::string_view, double>> units_like(std::string_view unit);
/// A text as a number and the unit behind it, which may be empty. Throws BadInput if it does not begin with a
/// number.
struct Written {
  double number;
  std::string unit;
};
Written written(std::string_view text);

/// A count: decimal digits only, without a sign or a leading zero. Empty if the text is anything else, or too
/// large.
std::optional<int> parse_count(std::string_view text);

}  // namespace oddity
