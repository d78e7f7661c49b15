// Lints the prose of the tree's files: prose TREE [FILE OR FOLDER]... <files, a name a line
//   git ls-files | prose .              lists all faults except those in tests/prose/accepted.txt
//   git ls-files | prose . chapters     lists those of a folder

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include "tests/prose/prose.hpp"

namespace {

namespace fs = std::filesystem;
using namespace oddity;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  return {std::istreambuf_iterator<char>(in), {}};
}

/// report/book is generated, and the linter's tests have faults on purpose.
bool is_linted(const fs::path& tree, const std::string& file) {
  return !file.starts_with("report/book/") && !file.starts_with("tests/prose/") &&
         file != "tests/test_prose.cpp" && fs::is_regular_file(tree / file);
}

bool is_at(const prose::Accepted& accepted, const std::string& file, const prose::Fault& fault) {
  return accepted.file == file && accepted.kind == fault.kind && fault.found.starts_with(accepted.words);
}

int lint(const fs::path& tree, const std::vector<std::string>& folders) {
  const auto rules = prose::rules_of(text_of(tree / "tests/prose/words.txt"));
  const auto accepted = prose::accepted_in(text_of(tree / "tests/prose/accepted.txt"));
  std::vector<bool> is_there(accepted.size());
  int red = 0;
  for (std::string file; std::getline(std::cin, file);) {
    const bool is_asked = folders.empty() || std::ranges::any_of(folders, [&](const auto& one) {
                            return file.starts_with(one);
                          });
    if (!is_asked || !is_linted(tree, file)) continue;
    for (const auto& passage : prose::passages_in(file, text_of(tree / file)))
      for (const auto& fault : prose::faults_in(passage, rules)) {
        const auto found =
            std::ranges::find_if(accepted, [&](const auto& one) { return is_at(one, file, fault); });
        if (found != accepted.end()) {
          is_there[static_cast<std::size_t>(found - accepted.begin())] = true;
          continue;
        }
        std::cout << file << ':' << fault.line << ": " << fault.kind << ": " << fault.found << "  ["
                  << fault.remedy << "]\n";
        ++red;
      }
  }
  for (std::size_t i = 0; i < accepted.size(); ++i)
    if (folders.empty() && !is_there[i]) {
      std::cout << accepted[i].file << ": " << accepted[i].kind << ": " << accepted[i].words
                << "  [accepted, but no longer there]\n";
      ++red;
    }
  return red > 0 ? 1 : 0;
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
