// Runs every command that writes under every fault: oddity_faults [VERB...] prints failures and counts. The
// table goes to the file ODDITY_FAULTS_TABLE as CSV. ODDITY_KILLS is the number of random trials, ODDITY_SEED
// their seed.

#include <iostream>

#include "extras/faults/trials.hpp"
#include "reference/files.hpp"
#include "tests/in_environment.hpp"
#include "tests/scratch_folder.hpp"

namespace {

bool is_asked(const std::string& verb, int argc, char** argv) {
  bool asked = argc < 2;
  for (int i = 1; i < argc; ++i) asked = asked || verb == argv[i];
  return asked;
}

}  // namespace

int main(int argc, char** argv) try {
  const ScratchFolder scratch;
  const faults::Installed program(scratch.path());
  const int kills = oddity::in_environment("ODDITY_KILLS", 20);
  const auto seed = static_cast<unsigned>(oddity::in_environment("ODDITY_SEED", 1));
  int verbs = 0, runs = 0, cells = 0, broken = 0;
  std::string table = "verb,fault,runs,broken\n";
  for (const faults::Verb& verb : faults::verbs(program)) {
    if (!is_asked(verb.name, argc, argv)) continue;
    const auto row = faults::try_faults(verb, program, {kills, std::min(kills, 40)}, seed);
    if (row.empty())
      std::cout << verb.name << ": not run, as the program is built without a library that it needs\n";
    verbs += !row.empty();
    for (const faults::Cell& cell : row) {
      ++cells;
      runs += cell.runs;
      broken += !cell.broken.empty();
      table += "\"" + cell.verb + "\"," + cell.fault + "," + std::to_string(cell.runs) + "," +
               std::to_string(cell.broken.size()) + "\n";
      for (const std::string& sentence : cell.broken)
        std::cout << cell.verb << ", " << cell.fault << ": " << sentence << "\n";
    }
    std::cout << verb.name << ": " << row.size() << " faults" << std::endl;
  }
  std::cout << "faults: " << verbs << " verbs that write, " << cells << " places of verb and fault, " << runs
            << " runs; " << (broken == 0 ? "all held" : std::to_string(broken) + " places do not hold")
            << "\n";
  if (const char* file = std::getenv("ODDITY_FAULTS_TABLE")) oddity::write_whole(file, table);
  return broken == 0 && verbs > 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << "oddity_faults: " << error.what() << "\n";
  return 2;
}
