#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "reference/bad_input.hpp"
#include "reference/enclosures/enclose.hpp"
#include "reference/files.hpp"
#include "reference/interrupted.hpp"
#include "reference/made_again.hpp"
#include "reference/truth.hpp"

using namespace oddity::truth;
namespace fs = std::filesystem;

namespace {

int bad_input(const std::string& message) {
  std::cerr << message
            << "\nusage: make_reference [--again] FOLDER [TABLE...]\n"
               "  for example: make_reference reference 03_05_quarter_period\n";
  return 2;
}

bool registered(const std::string& name) {
  return std::ranges::any_of(registry(), [&](const Entry& entry) { return entry.name == name; });
}

/// Distances by the table's enclosure, if Arb is installed.
Distances distances([[maybe_unused]] const std::string& name) {
#ifdef ODDITY_ARB
  return [name](const std::vector<double>& inputs, const std::vector<std::string>& decimals) {
    return oddity::distances_from_exact(name, inputs, decimals);
  };
#else
  return {};
#endif
}

/// Whether the table in the folder equals the generator's output; prints the differences.
bool as_made_again(const fs::path& file, const Entry& entry) {
  MadeAgain again(entry);
  for (std::size_t row = 0; row < again.rows(); ++row) again.make(row);
  std::ifstream stored(file);
  const std::vector<std::string> differences = again.differences(stored);
  for (const std::string& difference : differences) std::cerr << file.string() << ": " << difference << "\n";
  return differences.empty();
}

}  // namespace

/// make_reference FOLDER [TABLE...]: makes the named tables, or all of them, in FOLDER/tables. With --again
/// it computes them to fewer digits, and compares them with the existing ones.
int main(int argc, char** argv) {
  oddity::tidy_when_interrupted();
  const bool again = argc > 1 && std::string_view(argv[1]) == "--again";
  const int named = again ? 2 : 1;
  if (argc <= named) return bad_input("no folder is named");
  const fs::path folder = argv[named];
  if (!fs::is_directory(folder)) return bad_input(folder.string() + " is not a folder");
  const std::vector<std::string> wanted(argv + named + 1, argv + argc);
  for (const std::string& name : wanted)
    if (!registered(name))
      return bad_input(name + " is no table: a table is made by reference/make/TABLE.cpp");
  bool agree = true;
  for (const Entry& entry : registry()) {
    const std::string name(entry.name);
    if (!wanted.empty() && std::ranges::find(wanted, name) == wanted.end()) continue;
    if (wanted.empty() && !entry.home.empty()) continue;  // these tables are not in the tree
    const fs::path file = folder / "tables" / (name + ".csv");
    try {
      if (again) {
        agree &= as_made_again(file, entry);
        continue;
      }
      oddity::write_whole(file, table(name, entry.make(), distances(name)));
    } catch (const oddity::BadInput& error) {
      return bad_input(error.what());
    } catch (const std::exception& error) {
      std::cerr << "cannot make " << name << ": " << error.what() << "\n";
      return 1;
    }
    std::cout << file.string() << std::endl;
  }
  if (std::cout) return agree ? 0 : 1;
  std::cerr << "cannot write to standard output\n";
  return 2;
}
