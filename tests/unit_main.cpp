#include <iostream>

#include "tests/catch_main.hpp"

int main(int argc, char** argv) {
  oddity::CatchSession session({argv + 1, argv + argc});
  if (!session.accepted()) return 2;
  if (!session.only_lists() && session.selected().empty()) {
    std::cerr << "no test case matches\n";
    return 2;
  }
  return session.run() != 0;
}
