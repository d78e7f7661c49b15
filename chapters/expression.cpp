#include "chapters/expression.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

namespace oddity {

namespace {

/// The decimal as a whole number or a fraction over a power of ten.
std::string fraction(double x) {
  char buffer[400];
  char* const end = std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::fixed).ptr;
  std::string digits(&buffer[0], end);
  const std::size_t point = digits.find('.');
  if (point == std::string::npos) return digits;
  const std::size_t decimals = digits.size() - point - 1;
  digits.erase(point, 1);
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  return digits + " / 1" + std::string(decimals, '0');
}

}  // namespace

Expression::Expression(double x) {
  if (!std::isfinite(x)) throw std::logic_error("a number in a proof is not finite");
  text_ = fraction(std::abs(x));
  level_ = text_.find('/') == std::string::npos ? Level::atom : Level::product;
  if (x < 0) *this = -*this;
}

std::string Expression::within(Level level) const { return level_ <= level ? text_ : "(" + text_ + ")"; }

Expression operator+(const Expression& a, const Expression& b) {
  return {a.text_ + " + " + b.within(Expression::Level::product), Expression::Level::sum};
}
Expression operator-(const Expression& a, const Expression& b) {
  return {a.text_ + " - " + b.within(Expression::Level::product), Expression::Level::sum};
}
Expression operator*(const Expression& a, const Expression& b) {
  using enum Expression::Level;
  return {a.within(product) + " * " + b.within(sign), product};
}
Expression operator/(const Expression& a, const Expression& b) {
  using enum Expression::Level;
  return {a.within(product) + " / " + b.within(sign), product};
}
Expression operator-(const Expression& a) {
  using enum Expression::Level;
  return {"- " + a.within(power), sign};
}
Expression pow(const Expression& a, int exponent) {
  using enum Expression::Level;
  if (exponent < 0) return 1.0 / pow(a, -exponent);
  return {a.within(atom) + " ^ " + std::to_string(exponent), power};
}
Expression function(std::string_view name, const Expression& x) {
  return {std::string(name) + " (" + x.coq() + ")", Expression::Level::power};
}

}  // namespace oddity
