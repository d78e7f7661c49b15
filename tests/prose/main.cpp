// Lints the prose of the tree's files: prose TREE [--record | KIND | FOLDER]... <files, a name a line
//   git ls-files | prose . chapters     lists the faults of a folder
//   git ls-files | prose .              compares their counts with tests/prose/remaining.csv: none may rise
//   git ls-files | prose . --record     writes that file

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>

#include "tests/prose/prose.hpp"

namespace {

namespace fs = std::filesystem;
using namespace oddity;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Faults by kind and room.
using Counts = std::map<std::pair<std::string, std::string>, long>;

std::string room_of(const std::string& file) {
  const std::size_t slash = file.find('/');
  return slash == file.npos ? "." : file.substr(0, slash);
}

Counts recorded(const fs::path& file) {
  Counts counts;
  std::ifstream in(file);
  std::string kind, room, count;
  std::getline(in, kind);  // the heads
  while (std::getline(in, kind, ',') && std::getline(in, room, ',') && std::getline(in, count))
    counts[{kind, room}] = std::stol(count);
  return counts;
}

void record(const fs::path& file, const Counts& counts) {
  std::ofstream out(file);
  out << "kind,room,count\n";
  for (const auto& [of, count] : counts) out << of.first << ',' << of.second << ',' << count << '\n';
}

/// How many counts are higher than recorded.
int risen(const Counts& counts, const Counts& before) {
  int red = 0;
  for (const auto& [of, count] : counts) {
    const auto found = before.find(of);
    const long most = found == before.end() ? 0 : found->second;
    if (count <= most) continue;
    std::cout << of.first << " in " << of.second << ": " << count << " places, " << most << " at most\n";
    ++red;
  }
  return red;
}

int lint(const fs::path& tree, const std::vector<std::string>& shown) {
  const fs::path remaining = tree / "tests/prose/remaining.csv";
  const auto rules = prose::rules_of(text_of(tree / "tests/prose/words.txt"));
  Counts counts;
  for (std::string file; std::getline(std::cin, file);) {
    if (file.starts_with("report/book/") || file == "tests/prose/words.txt" ||
        !fs::is_regular_file(tree / file))
      continue;
    for (const auto& passage : prose::passages_in(file, text_of(tree / file)))
      for (const auto& fault : prose::faults_in(passage, rules)) {
        ++counts[{fault.kind, room_of(file)}];
        if (std::ranges::any_of(shown, [&](const auto& s) { return fault.kind == s || file.starts_with(s); }))
          std::cout << file << ':' << fault.line << ": " << fault.kind << ": " << fault.found << "  ["
                    << fault.remedy << "]\n";
      }
  }
  if (std::ranges::find(shown, "--record") != shown.end()) return record(remaining, counts), 0;
  return shown.empty() && risen(counts, recorded(remaining)) > 0 ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::cerr << "prose: the tree's folder is missing: git ls-files | prose .\n", 2;
  try {
    return lint(argv[1], {argv + 2, argv + argc});
  } catch (const std::exception& e) {
    std::cerr << "prose: " << e.what() << '\n';
    return 2;
  }
}
