#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "reference/truth.hpp"

/// make_reference FOLDER [TABLE...]: makes the named tables, or all of them, in FOLDER.
int main(int argc, char** argv) {
  using namespace oddity::truth;
  namespace fs = std::filesystem;
  if (argc < 2) {
    std::cerr << "usage: make_reference FOLDER [TABLE...]\n  for example: make_reference reference "
                 "03_05_quarter_period\n";
    return 2;
  }
  const std::vector<std::string> wanted(argv + 2, argv + argc);
  std::size_t made = 0;
  for (const Entry& entry : registry()) {
    const std::string name(entry.name);
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), name) == wanted.end()) continue;
    const fs::path file = fs::path(argv[1]) / (name + ".csv");
    const fs::path part = file.string() + ".part";
    std::string text;
    try {
      text = table(name, entry.make());
    } catch (const std::exception& error) {
      std::cerr << "cannot make " << name << ": " << error.what() << "\n";
      return 1;
    }
    std::ofstream out(part);
    out << text << std::flush;
    if (!out) {
      std::cerr << "cannot write " << part.string() << "\n";
      return 2;
    }
    out.close();
    fs::rename(part, file);
    std::cout << file.string() << "\n";
    ++made;
  }
  if (made < wanted.size()) {
    std::cerr << "no such table among:";
    for (const std::string& name : wanted) std::cerr << " " << name;
    std::cerr << "; a table is made by reference/make/TABLE.cpp\n";
    return 2;
  }
  return 0;
}
