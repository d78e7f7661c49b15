#include "formula/code.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <iterator>

namespace oddity::formula {

namespace {

std::string shortest(double x) {
  char buffer[40];
  return {std::begin(buffer), std::to_chars(std::begin(buffer), std::end(buffer), x).ptr};
}

std::string of_coq(std::string_view name) {
  return name == "log" ? "ln" : name == "abs" ? "Rabs" : std::string(name);
}

}  // namespace

std::string Cpp::number(double x) {
  const std::string digits = shortest(x);
  return digits.find_first_of(".en") == std::string::npos ? digits + ".0" : digits;
}
std::string Cpp::function(std::string_view name, const std::string& x) {
  return std::string(name) + "(" + x + ")";
}
std::string Cpp::power(const std::string& x, int exponent) {
  return exponent == 2 ? "(" + x + " * " + x + ")" : "pow(" + x + ", " + std::to_string(exponent) + ")";
}

std::string CSharp::number(double x) { return shortest(x); }
std::string CSharp::function(std::string_view name, const std::string& x) {
  if (name == "remainder") return "Math.IEEERemainder(" + x + ")";
  const char first = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  const bool is_its_own = name != "hypot" && name != "expm1" && name != "asinh" && name != "copysign";
  return (is_its_own ? "Math." : "") + std::string(1, first) + std::string(name.substr(1)) + "(" + x + ")";
}
std::string CSharp::power(const std::string& x, int exponent) {
  return "Math.Pow(" + x + ", " + std::to_string(exponent) + ")";
}

std::string JavaScript::number(double x) { return shortest(x); }
std::string JavaScript::function(std::string_view name, const std::string& x) {
  return "Math." + std::string(name) + "(" + x + ")";
}
std::string JavaScript::power(const std::string& x, int exponent) {
  return x + " ** " + std::to_string(exponent);
}

std::string Coq::number(double x) {
  char buffer[400];
  std::string digits(std::begin(buffer),
                     std::to_chars(std::begin(buffer), std::end(buffer), x, std::chars_format::fixed).ptr);
  const std::size_t point = digits.find('.');
  if (point == std::string::npos) return digits;
  const std::size_t decimals = digits.size() - point - 1;
  digits.erase(point, 1);
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1));
  return digits + " / 1" + std::string(decimals, '0');
}
std::string Coq::function(std::string_view name, const std::string& x) {
  return of_coq(name) + " (" + x + ")";
}
std::string Coq::power(const std::string& x, int exponent) { return x + " ^ " + std::to_string(exponent); }

std::string code_name(std::string_view letter) {
  std::string name;
  for (const char c : plain_name(letter)) name += c == '\'' ? "_dot" : std::string(1, c);
  return name;
}

}  // namespace oddity::formula
