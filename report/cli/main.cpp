#include "extras/bench/verb.hpp"
#include "extras/engines/verb.hpp"
#include "extras/lanes/price.hpp"
#include "extras/sweep/verb.hpp"
#include "report/cli/commands.hpp"
#include "report/verify/verify.hpp"

int main(int argc, char** argv) {
  using namespace oddity;
  return command_line(argc, argv, verify,
                      {{add_bench, add_engines, add_sweep}, lanes::bodies_in_lanes(), other_engines()});
}
