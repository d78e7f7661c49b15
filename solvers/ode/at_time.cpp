#include <charconv>

#include "solvers/ode/integrate_inlined.hpp"

namespace oddity::ode::detail {

std::string at_time(const char* what, double t) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, t, std::chars_format::general, 7).ptr;
  return std::string(what) + " at t = " + std::string(digits, end);
}

}  // namespace oddity::ode::detail
