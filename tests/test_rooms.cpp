#include <filesystem>
#include <fstream>
#include <regex>
#include <set>

#include "tests/catch.hpp"

namespace fs = std::filesystem;

namespace {

/// The files that a source file of ours includes by quotes, and those by angle brackets.
std::set<std::string> includes(const fs::path& file, const std::string& open) {
  std::ifstream in(file);
  const std::regex pattern("^#include " + open + "([^\">]+)[\">]");
  std::set<std::string> found;
  std::smatch match;
  for (std::string line; std::getline(in, line);)
    if (std::regex_search(line, match, pattern)) found.insert(match[1]);
  return found;
}

std::vector<fs::path> sources(const std::string& room) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ODDITY_SOURCE) / room))
    if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp")
      files.push_back(entry.path());
  return files;
}

/// Every quoted include of the room's files starts with one of the rooms that it may know.
void may_know(const std::string& room, const std::vector<std::string>& rooms) {
  const auto files = sources(room);
  REQUIRE_FALSE(files.empty());
  for (const fs::path& file : files)
    for (const std::string& included : includes(file, "\"")) {
      INFO(file.string() << " includes " << included);
      CHECK(std::any_of(rooms.begin(), rooms.end(),
                        [&](const auto& known) { return included.rfind(known + "/", 0) == 0; }));
    }
}

}  // namespace

TEST_CASE("each room knows only the rooms below it", "[rooms]") {
  may_know("solvers", {"solvers"});
  may_know("reference", {"reference"});
  may_know("chapters", {"chapters", "solvers", "reference"});
  for (const fs::path& file : sources("report"))
    if (file.filename() != "main.cpp")
      for (const std::string& included : includes(file, "\"")) {
        INFO(file.string() << " includes " << included);
        CHECK(included.rfind("tests/", 0) != 0);
        const bool may = included == "solvers/ode/catalog.hpp" || file.filename() == "bench_loops.cpp";
        CHECK((may || included.rfind("solvers/", 0) != 0));
      }
}

TEST_CASE("the vocabulary needs the standard library only", "[rooms]") {
  const fs::path vocabulary = fs::path(ODDITY_SOURCE) / "chapters" / "exercise.hpp";
  CHECK(includes(vocabulary, "\"") == std::set<std::string>{"solvers/solved.hpp"});
  for (const std::string& included : includes(vocabulary, "<"))
    CHECK(included.find('/') == std::string::npos);
}

TEST_CASE("exercises do not print, test, look at a clock or draw from the library's distributions",
          "[rooms]") {
  const std::set<std::string> forbidden{"iostream", "cstdio", "print",           "chrono",
                                        "ctime",    "random", "catch2/catch.hpp"};
  for (const fs::path& file : sources("chapters"))
    for (const std::string& included : includes(file, "<")) {
      INFO(file.string() << " includes " << included);
      CHECK(forbidden.count(included) == 0);
    }
}
