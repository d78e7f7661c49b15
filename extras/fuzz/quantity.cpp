// A number with a unit, for each unit of a parameter or an option.
#include "reference/quantity_text.hpp"

#include <array>

#include "extras/fuzz/fuzz.hpp"

void fuzz::read(std::string_view input) {
  static constexpr std::array units{"",    "1",  "m",   "s", "rad", "kg", "m/s^2", "AU^3/(yr^2 solar mass)",
                                    "N/m", "Hz", "bins"};
  if (input.empty()) return;
  oddity::in_unit(input.substr(1), units[static_cast<unsigned char>(input.front()) % units.size()]);
}
