#include "report/text/numbers.hpp"

#include <cmath>

#include "reference/text.hpp"

namespace oddity {

std::string two_digits(double x) {
  const std::string text = format_significant(x, 2);
  const double rounded = parse_number(text).value_or(x), size = std::abs(rounded);
  return size >= 100 && size < 1e6 ? std::to_string(std::lround(rounded)) : text;
}

std::string percent(double part) { return format_significant(100 * part, 2) + " %"; }

}  // namespace oddity
