#include "chapters/claims.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "reference/text.hpp"

namespace oddity {

namespace {

struct Written {
  double number;
  int decimals;
};

Written read(const std::string& written) {
  std::string digits = written;
  std::erase(digits, '$');
  double number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc{} || end != digits.data() + digits.size())
    throw std::logic_error("'" + written + "' is no number");
  const auto point = digits.find('.'), power = digits.find_first_of("eE");
  int decimals =
      point == std::string::npos ? 0 : static_cast<int>(std::min(power, digits.size()) - point) - 1;
  if (power != std::string::npos) decimals -= std::stoi(digits.substr(power + 1));
  return {number, decimals};
}

}  // namespace

Check as_written(std::string quantity, const std::string& written, const Route& truth) {
  const Written x = read(written);
  return {std::move(quantity), {"as written, " + written, x.number}, truth, printed_decimals(x.decimals)};
}

Check as_cut_off(std::string quantity, const std::string& written, const Route& truth) {
  const Written x = read(written);
  const double half = std::copysign(0.5 * std::pow(10.0, -x.decimals), x.number);
  return {std::move(quantity),
          {"the middle of the numbers that begin with " + written, x.number + half},
          truth,
          printed_decimals(x.decimals)};
}

std::pair<std::string, std::string> sides_of_equation(const std::string& text) {
  std::vector<std::string> sides;
  const std::string first = text.substr(0, text.find('$', 1) + 1);
  if (is_formula(first)) sides = formula::sides_of(first.substr(1, first.size() - 2)).sides;
  if (sides.size() < 2) throw std::logic_error(text + " is no equation $a=b$");
  std::string right = sides[1];
  for (std::size_t i = 2; i < sides.size(); ++i) right += ",\\ " + sides[i];
  return {"$" + sides[0] + "$", sides.size() == 2 ? "$" + right + "$" : "$(" + right + ")$"};
}

Claims& Claims::number(std::string_view slug, int line, std::string says, const NumberClaim& parts) {
  const std::string quantity = parts.quantity.empty() ? says : parts.quantity;
  return judged(slug, line, std::move(says), parts, {}, [&](const std::string& written) -> Reading {
    if (written.empty()) return {};
    return {written, {as_written(quantity, written, parts.truth)}};
  });
}

Claims& Claims::add(std::string_view slug, int line, std::string says, Claim parts) {
  parts.id = exercise_ + "-" + std::string(slug);
  parts.line = line;
  parts.says = std::move(says);
  if (parts.kind == Fault::none && !parts.meant.text.empty()) parts.kind = Fault::lost_typography;
  if (parts.kind == Fault::none && !parts.corrected.text.empty())
    parts.kind = parts.in_view.text.empty() ? Fault::formula : Fault::left_out;
  claims_.push_back(std::move(parts));
  return *this;
}

std::vector<Claim> Claims::in_order() const {
  std::string differences;
  for (const std::string& one : differences_) differences += (differences.empty() ? "" : "; ") + one;
  if (!differences.empty()) throw std::logic_error(differences);
  std::vector<Claim> sorted = claims_;
  std::ranges::stable_sort(sorted, {}, &Claim::line);
  return sorted;
}

}  // namespace oddity
