#include "extras/engines/labels.hpp"

#include <cmath>
#include <numbers>

#include "report/text/numbers.hpp"

namespace oddity {

std::string full_name(const EngineSeries& s) {
  return s.engine + (s.variant == "defaults" ? "" : ", " + s.variant) + (s.webassembly ? " *" : "");
}

namespace {

/// "3.4 cm", "0.12 deg": an error in units that a reader can picture.
std::string of_one(double error, const std::string& unit) {
  if (!std::isfinite(error)) return "-";
  if (unit == "m") return two_digits(100 * error) + " cm";
  if (unit == "rad") return two_digits(180 / std::numbers::pi * error) + " deg";
  return two_digits(error) + " " + unit;
}

}  // namespace

std::string pictured(const std::vector<double>& errors, const std::vector<std::string>& units) {
  std::string text;
  for (std::size_t i = 0; i < errors.size(); ++i) text += (i == 0 ? "" : ", ") + of_one(errors[i], units[i]);
  return text;
}

std::string in_percent(double part) {
  if (!std::isfinite(part)) return "";
  return part < 1e-6 ? "0" : two_digits(100 * part);
}

}  // namespace oddity
