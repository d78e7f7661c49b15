#include "report/cli/needs.hpp"

#include <iostream>

namespace oddity {

namespace {

bool& only_needs() {
  static bool only = false;
  return only;
}

}  // namespace

void ask_for_needs() { only_needs() = true; }
bool needs_are_asked() { return only_needs(); }

bool needs_are_all(const Needs& needs) {
  if (!needs_are_asked()) return false;
  for (const std::string& name : needs.packages) std::cout << "package " << name << "\n";
  for (const std::string& folder : needs.npm) std::cout << "npm " << folder << "\n";
  for (const std::string& name : needs.targets) std::cout << "target " << name << "\n";
  return true;
}

}  // namespace oddity
