#include <iostream>

#include "reference/bad_input.hpp"
#include "report/verify/catch_main.hpp"

int main(int argc, char** argv) try {
  oddity::CatchSession session({argv + 1, argv + argc});
  if (!session.accepted()) return 2;
  if (!session.only_lists() && session.selected().empty()) {
    std::cerr << "no test case matches\n";
    return 2;
  }
  return session.run() != 0;
} catch (const oddity::BadInput& error) {
  std::cerr << error.what() << "\n";
  return 2;
}
