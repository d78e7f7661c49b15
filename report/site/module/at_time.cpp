// Replaces solvers/ode/at_time.cpp: std::to_chars for a double would add a hundred kilobytes of tables.

#include <cstdio>

#include "solvers/ode/integrate_inlined.hpp"

namespace oddity::ode::detail {

std::string at_time(const char* what, double t) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.7g", t);
  return std::string(what) + " at t = " + digits;
}

}  // namespace oddity::ode::detail
