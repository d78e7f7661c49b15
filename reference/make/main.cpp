#include <algorithm>
#include <filesystem>
#include <iostream>

#include "reference/bad_input.hpp"
#include "reference/enclosures/enclose.hpp"
#include "reference/files.hpp"
#include "reference/interrupted.hpp"
#include "reference/truth.hpp"

using namespace oddity::truth;
namespace fs = std::filesystem;

namespace {

int bad_input(const std::string& message) {
  std::cerr << message
            << "\nusage: make_reference FOLDER [TABLE...]\n"
               "  for example: make_reference reference 03_05_quarter_period\n";
  return 2;
}

bool registered(const std::string& name) {
  return std::ranges::any_of(registry(), [&](const Entry& entry) { return entry.name == name; });
}

/// From the enclosures of this table, where Arb is installed.
Distances distances([[maybe_unused]] const std::string& name) {
#ifdef ODDITY_ARB
  return [name](const std::vector<double>& inputs, const std::vector<std::string>& decimals) {
    return oddity::distances_from_exact(name, inputs, decimals);
  };
#else
  return {};
#endif
}

}  // namespace

/// make_reference FOLDER [TABLE...]: makes the named tables, or all of them, in FOLDER/tables.
int main(int argc, char** argv) {
  oddity::tidy_when_interrupted();
  if (argc < 2) return bad_input("no folder is named");
  const fs::path folder = argv[1];
  if (!fs::is_directory(folder)) return bad_input(folder.string() + " is not a folder");
  const std::vector<std::string> wanted(argv + 2, argv + argc);
  for (const std::string& name : wanted)
    if (!registered(name))
      return bad_input(name + " is no table: a table is made by reference/make/TABLE.cpp");
  for (const Entry& entry : registry()) {
    const std::string name(entry.name);
    if (!wanted.empty() && std::ranges::find(wanted, name) == wanted.end()) continue;
    if (wanted.empty() && !entry.home.empty()) continue;  // whose tables are not the tree's
    const fs::path file = folder / "tables" / (name + ".csv");
    try {
      oddity::write_whole(file, table(name, entry.make(), distances(name)));
    } catch (const oddity::BadInput& error) {
      return bad_input(error.what());
    } catch (const std::exception& error) {
      std::cerr << "cannot make " << name << ": " << error.what() << "\n";
      return 1;
    }
    std::cout << file.string() << std::endl;
  }
  if (std::cout) return 0;
  std::cerr << "cannot write to standard output\n";
  return 2;
}
