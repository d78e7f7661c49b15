// As solvers/ode/at_time.cpp, without the hundred kilobytes of tables that std::to_chars has for a double.

#include <cstdio>

#include "solvers/ode/integrate_inlined.hpp"

namespace oddity::ode::detail {

std::string at_time(const char* what, double t) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.7g", t);
  return std::string(what) + " at t = " + digits;
}

}  // namespace oddity::ode::detail
