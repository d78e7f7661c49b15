#include "tests/catch_main.hpp"

int main(int argc, char** argv) {
  oddity::CatchSession session({argv + 1, argv + argc});
  return session.accepted() ? session.run() != 0 : 2;
}
