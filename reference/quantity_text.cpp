#include "reference/quantity_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>

#include "reference/bad_input.hpp"

namespace oddity {

namespace {

// The double: 30deg then equals the double of the tables and of pi / 6 in the code.
constexpr long double pi = std::numbers::pi;
constexpr long double day = 86400, metres_in_au = 149597870700;

/// The powers of the base units.
struct Powers {
  int m = 0, s = 0, kg = 0, rad = 0, solar_mass = 0, bins = 0, A = 0;

  bool operator==(const Powers&) const = default;
};

/// Size of a unit in its base units, and their powers.
struct Unit {
  long double size = 1;
  Powers powers = {};

  void multiply(const Unit& other, int power) {
    size *= std::pow(other.size, power);
    for (int Powers::*base :
         {&Powers::m, &Powers::s, &Powers::kg, &Powers::rad, &Powers::solar_mass, &Powers::bins, &Powers::A})
      powers.*base += other.powers.*base * power;
  }
};

const std::map<std::string, Unit, std::less<>>& named_units() {
  static const std::map<std::string, Unit, std::less<>> units{
      {"m", {1, {.m = 1}}},
      {"s", {1, {.s = 1}}},
      {"g", {1e-3L, {.kg = 1}}},
      {"kg", {1, {.kg = 1}}},  // exactly
      {"rad", {1, {.rad = 1}}},
      {"N", {1, {.m = 1, .s = -2, .kg = 1}}},
      {"J", {1, {.m = 2, .s = -2, .kg = 1}}},
      {"W", {1, {.m = 2, .s = -3, .kg = 1}}},
      {"Hz", {1, {.s = -1}}},
      {"Pa", {1, {.m = -1, .s = -2, .kg = 1}}},
      {"A", {1, {.A = 1}}},
      {"V", {1, {.m = 2, .s = -3, .kg = 1, .A = -1}}},
      {"Ohm", {1, {.m = 2, .s = -3, .kg = 1, .A = -2}}},
      {"H", {1, {.m = 2, .s = -2, .kg = 1, .A = -2}}},
      {"min", {60, {.s = 1}}},
      {"h", {3600, {.s = 1}}},
      {"d", {day, {.s = 1}}},
      {"yr", {365.25L * day, {.s = 1}}},
      {"AU", {metres_in_au, {.m = 1}}},
      {"deg", {pi / 180, {.rad = 1}}},
      {"°", {pi / 180, {.rad = 1}}},
      {"rpm", {2 * pi / 60, {.s = -1, .rad = 1}}},
      {"solar mass", {1, {.solar_mass = 1}}},
      {"bins", {1, {.bins = 1}}},
      {"%", {0.01L}},
  };
  return units;
}

constexpr std::string_view with_prefixes[]{"m",   "s",  "g", "N", "J",   "W", "Hz",
                                           "rad", "Pa", "A", "V", "Ohm", "H"};
constexpr std::pair<std::string_view, long double> prefixes[]{{"p", 1e-12L},
                                                              {"n", 1e-9L},
                                                              {"u", 1e-6L},
                                                              {"µ", 1e-6L},
                                                              {"μ", 1e-6L},  // the micro sign, and the letter
                                                                             // mu
                                                              {"m", 1e-3L},
                                                              {"c", 1e-2L},
                                                              {"d", 1e-1L},
                                                              {"k", 1e3L},
                                                              {"M", 1e6L},
                                                              {"G", 1e9L}};

std::optional<Unit> named(std::string_view name) {
  const auto& units = named_units();
  if (const auto found = units.find(name); found != units.end()) return found->second;
  for (const auto& [prefix, size] : prefixes)
    for (std::string_view base : with_prefixes)
      if (name.size() == prefix.size() + base.size() && name.starts_with(prefix) && name.ends_with(base)) {
        Unit unit = units.find(base)->second;
        unit.size *= size;
        return unit;
      }
  return std::nullopt;
}

/// Reads "AU^3/(yr^2 solar mass)": adjacent factors, or those with '*', are multiplied; a '/' divides by the
/// next.
class UnitReader {
 public:
  explicit UnitReader(std::string_view text) : left_(text) {}

  std::optional<Unit> whole() {
    while (take(" ")) {
    }
    const auto unit = product(take("/") ? -1 : 1);  // "60 /s"
    return left_.empty() ? unit : std::nullopt;
  }

 private:
  bool take(std::string_view token) {
    if (!left_.starts_with(token)) return false;
    left_.remove_prefix(token.size());
    return true;
  }

  std::optional<Unit> product(int sign = 1) {
    Unit all;
    for (bool is_first = true;;) {
      while (take(" ")) {
      }
      const auto next = factor(is_first && sign == 1);
      is_first = false;
      if (!next) return std::nullopt;
      const auto power = exponent();
      if (!power) return std::nullopt;
      all.multiply(*next, sign * *power);
      while (take(" ")) {
      }
      if (left_.empty() || left_.front() == ')') return all;
      sign = take("/") ? -1 : 1;
      if (sign == 1 && !take("*")) take("·");
    }
  }

  /// Reads a factor. A 1 is allowed only before a '/', as in 1/s.
  std::optional<Unit> factor(bool is_first) {
    if (take("(")) {
      if (++open_ > most_open) return std::nullopt;
      const auto inside = product();
      --open_;
      return take(")") ? inside : std::nullopt;
    }
    if (take("solar mass")) return named("solar mass");
    if (take("1")) return is_first && left_.starts_with('/') ? std::optional(Unit()) : std::nullopt;
    const std::string_view name = left_.substr(0, left_.find_first_of(" */^()0123456789-"));
    for (std::string_view end : {"²", "³", "·"})
      if (const auto at = name.find(end); at != std::string_view::npos) return named(cut(at));
    return named(cut(name.size()));
  }

  std::string_view cut(std::size_t size) {
    const std::string_view name = left_.substr(0, size);
    left_.remove_prefix(size);
    return name;
  }

  /// The exponent; 1 if omitted. Rejects a written 0 or 1.
  std::optional<int> exponent() {
    if (take("²")) return 2;
    if (take("³")) return 3;
    const bool must = take("^");
    int power = 1;
    const auto [end, error] = std::from_chars(left_.data(), left_.data() + left_.size(), power);
    if (error != std::errc()) return must ? std::nullopt : std::optional(1);
    left_.remove_prefix(static_cast<std::size_t>(end - left_.data()));
    return power != 0 && power != 1 && std::abs(power) <= 9 ? std::optional(power) : std::nullopt;
  }

  static constexpr int most_open = 4;  // parentheses; keeps powers within the range of int
  std::string_view left_;
  int open_ = 0;
};

constexpr std::string_view usual_units[]{
    "m",      "cm",    "mm",     "km",  "AU",   "s",   "ms",  "us",   "ns",    "min",   "h",     "d",
    "yr",     "kg",    "g",      "rad", "mrad", "deg", "m/s", "km/h", "AU/yr", "rad/s", "deg/s", "rpm",
    "rad/yr", "m/s^2", "cm/s^2", "N",   "mN",   "kN",  "1/s", "Hz",   "N/m",   "N/cm"};

std::string fitting(std::string_view unit) {
  std::string names;
  for (const auto& [name, size] : units_like(unit)) names += (names.empty() ? "" : ", ") + std::string(name);
  return names.empty() ? std::string(unit) : names;
}

/// A declared unit; empty and "1" mean pure numbers.
std::optional<Unit> declared(std::string_view unit) {
  return unit.empty() || unit == "1" ? Unit() : UnitReader(unit).whole();
}

}  // namespace

std::optional<UnitText> unit_of(std::string_view text) {
  const auto unit = UnitReader(text).whole();
  if (!unit) return std::nullopt;
  const Powers& p = unit->powers;
  return UnitText{unit->size, {p.m, p.s, p.kg, p.A, p.rad, p.solar_mass, p.bins}};
}
bool is_unit(std::string_view text) { return declared(text).has_value(); }
std::vector<std::pair<std::string_view, double>> units_like(std::string_view unit) {
  std::vector<std::pair<std::string_view, double>> all;
  const auto wanted = declared(unit);
  for (std::string_view name : usual_units)
    if (const Unit usual = *UnitReader(name).whole(); wanted && usual.powers == wanted->powers)
      all.emplace_back(name, static_cast<double>(usual.size / wanted->size));
  return all;
}

Written written(std::string_view text) {
  const std::string_view number = text.starts_with('+') ? text.substr(1) : text;
  double value{};
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  const std::string quoted = "'" + std::string(text) + "'";
  if (error == std::errc::result_out_of_range) throw BadInput(quoted + " is outside the range of numbers");
  if (error != std::errc() || (text.starts_with('+') && number.starts_with('-')))
    throw BadInput(quoted + " is not a number");
  std::string_view unit = number.substr(static_cast<std::size_t>(end - number.data()));
  unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
  return {value, std::string(unit)};
}

double in_unit(std::string_view text, std::string_view unit) {
  const auto [value, symbol] = written(text);
  if (symbol.empty()) return value;

  const std::string quoted = "'" + std::string(text) + "'";
  if (!is_unit(unit))
    throw BadInput(quoted + " is for a parameter whose own unit, '" + std::string(unit) +
                   "', is unknown: give the number alone, and declare a unit such as 'm/s^2'");
  const Unit wanted = declared(unit).value();
  const auto given = UnitReader(symbol).whole();
  if (given && given->powers == wanted.powers) {
    const auto converted = static_cast<double>(static_cast<long double>(value) * (given->size / wanted.size));
    if (std::isfinite(converted) || !std::isfinite(value)) return converted;
    throw BadInput(quoted + " is outside the range of numbers");
  }
  throw BadInput(
      quoted + (given ? " has a unit that does not fit" : " is not a number, nor one with a unit") +
      (wanted.powers == Powers() ? ": this one has no unit" : "; units that fit: " + fitting(unit)));
}

std::optional<int> parse_count(std::string_view text) {
  if (text.empty() || text.find_first_not_of("0123456789") != text.npos ||
      (text.size() > 1 && text[0] == '0'))
    return std::nullopt;
  int count{};
  const auto error = std::from_chars(text.data(), text.data() + text.size(), count).ec;
  return error == std::errc() ? std::optional(count) : std::nullopt;
}

}  // namespace oddity
