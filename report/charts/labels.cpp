#include "report/charts/labels.hpp"

#include <algorithm>
#include <cmath>

#include "reference/text.hpp"
#include "report/text/markup.hpp"

namespace oddity {

std::string shown(const Value& value, int digits) {
  constexpr std::size_t most = 4;
  const auto component = [digits](double x) { return std::isnan(x) ? "nan" : format_significant(x, digits); };
  if (value.size() == 1) return component(value[0]);
  std::string text = "(";
  for (std::size_t i = 0; i < std::min(value.size(), most); ++i)
    text += (i ? ", " : "") + component(value[i]);
  return text + (value.size() > most ? ", ... " + std::to_string(value.size()) + " in all)" : ")");
}

std::string shown_error(double error) { return std::isfinite(error) ? format_significant(error, 2) : "-"; }

std::string shown_time(double seconds) {
  if (!std::isfinite(seconds)) return "-";
  if (seconds < 1e-6) return format_significant(seconds * 1e9, 3) + " ns";
  if (seconds < 1e-3) return format_significant(seconds * 1e6, 3) + " us";
  return seconds < 1 ? format_significant(seconds * 1e3, 3) + " ms" : format_significant(seconds, 3) + " s";
}

std::string shown_resolution(const TimedTrial& t) {
  return t.resolution.empty() ? "-" : t.resolution + " " + format_significant(t.setting, 4);
}

std::string error_cell(double error) { return with_powers(shown_error(error)); }
std::string resolution_cell(const TimedTrial& t) { return with_powers(escaped(shown_resolution(t))); }
std::string value_cell(const Value& value, int digits) { return with_powers(shown(value, digits)); }

}  // namespace oddity
