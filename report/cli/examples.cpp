#include "report/cli/examples.hpp"

#include <algorithm>
#include <array>
#include <sstream>

namespace oddity {

namespace {

constexpr std::array<Mark, 17> marks{{
    {"oddity bench", "slow, exit 0 or 1"},  // on a busy machine its limits break
    {"oddity bench --csv", "slow, exit 0 or 1"},
    {"oddity bench --lanes 3.5 3.33", "slow, exit 0 or 1"},
    {"oddity bench --verbs", "slow"},
    {"oddity engines", "not, takes hours"},
    {"oddity engines 3.33 'free body' --hz 60,240,960", "slow"},
    {"oddity engines 3.5 a=60deg --horizon 30", "slow"},
    {"oddity engines 3.5 --criterion energy --error 5%", "slow"},
    {"oddity prove", "not, takes an hour"},
    {"oddity prove 3.5 7.9 --out /tmp/proofs", "not, needs Coq, which ./oddity prove installs"},
    {"mpirun -n 8 oddity sweep run /tmp/map", "not, needs eight cores"},
    {"oddity sweep run /tmp/map --slurm 100 | sbatch", "not, needs Slurm"},
    {"oddity sweep merge /tmp/map", "exit 0 or 2"},  // asks for a .csv if HDF5 was installed after the build
    {"oddity sweep merge /tmp/map /mnt/other/map --out map.csv", "exit 2"},  // nothing is mounted there
    {"oddity sweep draw /tmp/map --show error --out e.svg", "not, needs a map of every cell"},
    {"oddity new 3.2 spring_pendulum", "exit 2"},  // an installed program has no tree
    {"oddity new 9.2 law_of_cosines --identity", "exit 2"},
}};

std::string_view mark_of(std::string_view example) {
  const auto found = std::ranges::find(marks, example, &Mark::example);
  return found == marks.end() ? "-" : found->says;
}

/// Adds the new examples of a verb, and of its subcommands.
void add_examples(const CLI::App& verb, std::string& all) {
  std::istringstream footer(verb.get_footer());
  bool begun = false;
  for (std::string line; std::getline(footer, line);) {
    begun |= line.starts_with("Example");
    const auto at = line.find(line.starts_with("Example: ") ? "oddity" : "  ");
    if (!begun || at == std::string::npos) continue;
    const std::string example = line.substr(line.find_first_not_of(' ', at));
    if (all.find("\t" + example + "\n") == std::string::npos)
      all += std::string(mark_of(example)) + "\t" + example + "\n";
  }
  for (const CLI::App* within : verb.get_subcommands({})) add_examples(*within, all);
}

}  // namespace

std::span<const Mark> marks_of_examples() { return marks; }

std::string examples_of(const CLI::App& app) {
  std::string all;
  add_examples(app, all);
  return all;
}

}  // namespace oddity
