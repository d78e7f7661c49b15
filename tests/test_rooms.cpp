#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>

#include "chapters/contents.hpp"
#include "reference/files.hpp"
#include "report/verify/catch.hpp"

namespace fs = std::filesystem;

namespace {

/// The names that a source file includes between `open` and `close`: "" or <>.
std::set<std::string> includes(const fs::path& file, char open, char close) {
  std::ifstream in(file);
  const std::string start = std::string("#include ") + open;
  std::set<std::string> found;
  for (std::string line; std::getline(in, line);)
    if (line.rfind(start, 0) == 0)
      found.insert(line.substr(start.size(), line.find(close, start.size()) - start.size()));
  return found;
}
std::set<std::string> ours(const fs::path& file) { return includes(file, '"', '"'); }
std::set<std::string> others(const fs::path& file) { return includes(file, '<', '>'); }

std::vector<fs::path> sources(const std::string& room) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ODDITY_SOURCE) / room))
    if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp")
      files.push_back(entry.path());
  return files;
}

/// Requires that every quoted include of the room's files starts with one of these rooms.
void may_know(const std::string& room, const std::vector<std::string>& rooms) {
  const auto files = sources(room);
  REQUIRE_FALSE(files.empty());
  for (const fs::path& file : files)
    for (const std::string& included : ours(file)) {
      INFO(file.string() << " includes " << included);
      CHECK(std::any_of(rooms.begin(), rooms.end(), [&](const auto& known) {
        return included == known || included.rfind(known + "/", 0) == 0;
      }));
    }
}

/// A path of includes from the file to one of these headers, "a > b > c", or empty.
std::string path_to(const std::set<std::string>& headers, const std::string& file,
                    std::set<std::string>& seen) {
  for (const std::string& included : ours(fs::path(ODDITY_SOURCE) / file)) {
    if (headers.count(included) > 0) return file + " > " + included;
    if (!seen.insert(included).second) continue;
    if (const std::string rest = path_to(headers, included, seen); !rest.empty()) return file + " > " + rest;
  }
  return {};
}

}  // namespace

TEST_CASE("each room includes only the rooms below it", "[rooms]") {
  may_know("formula", {"formula"});
  may_know("solvers", {"solvers"});
  may_know("reference", {"reference", "solvers/stop.hpp"});
  may_know("chapters", {"chapters", "solvers", "reference", "formula"});
  may_know("problem", {"problem", "chapters", "solvers", "reference", "formula"});
  for (const fs::path& file : sources("report"))
    if (file.filename() != "main.cpp")
      for (const std::string& included : ours(file)) {
        INFO(file.string() << " includes " << included);
        CHECK(included.rfind("tests/", 0) != 0);
        CHECK(included.rfind("extras/", 0) != 0);
        const bool may = included == "solvers/ode/catalog.hpp" || included == "solvers/stop.hpp" ||
                         included == "solvers/ode/steps_in.hpp" ||
                         included == "solvers/ode/step_lengths.hpp" ||
                         included == "solvers/ode/known_tongues.hpp" ||
                         (included == "solvers/ode/velocities.hpp" &&  // printed along by `choose --code`
                          file.parent_path().filename() == "plain") ||
                         file.parent_path().filename() == "module" ||
                         file.parent_path().parent_path().filename() == "module";
        CHECK((may || included.rfind("solvers/", 0) != 0));
      }
}

TEST_CASE("a product of extras includes the core, itself and few others", "[rooms]") {
  const std::map<std::string, std::string> others{{"bench", "extras/lanes"}, {"fuzz", "extras/sweep"}};
  for (const auto& product : fs::directory_iterator(fs::path(ODDITY_SOURCE) / "extras"))
    if (product.is_directory()) {
      const std::string name = product.path().filename().string(), room = "extras/" + name;
      const auto other = others.find(name);
      may_know(room, {"formula", "solvers", "reference", "chapters", "problem", "report", "tests", room,
                      other == others.end() ? room : other->second});
    }
}

TEST_CASE("the floors of report include only those before them", "[rooms]") {
  const std::vector<std::string> floors{"text", "study", "charts", "pages", "site"};
  for (std::size_t i = 0; i < floors.size(); ++i) {
    std::vector<std::string> known{"chapters", "solvers", "reference"};
    for (std::size_t k = 0; k <= i; ++k) known.push_back("report/" + floors[k]);
    if (i > 0) known.push_back("formula");
    if (floors[i] == "site") known.push_back("problem");  // the page in which one types a file
    may_know("report/" + floors[i],
             i > 0 ? known : std::vector<std::string>{"report/text", "reference", "formula"});
  }
}

TEST_CASE("a header of report has its body in the same room", "[rooms]") {
  for (const fs::path& file : sources("report")) {
    if (file.extension() != ".cpp") continue;
    std::string own = file.lexically_relative(ODDITY_SOURCE).generic_string();
    own.replace(own.size() - 4, 4, ".hpp");
    if (!fs::exists(fs::path(ODDITY_SOURCE) / own)) continue;
    INFO(own);
    CHECK(ours(file).count(own) == 1);
  }
}

TEST_CASE("a header of the chapters has two includers or more, else it is a source file", "[rooms]") {
  std::map<std::string, int> includers;
  for (const char* room :
       {"chapters", "problem", "formula", "solvers", "reference", "report", "tests", "extras"})
    for (const fs::path& file : sources(room))
      for (const std::string& included : ours(file)) ++includers[included];
  for (const fs::path& file : sources("chapters")) {
    const std::string name = file.lexically_relative(ODDITY_SOURCE).generic_string();
    // Drawings and models are also included by files written by CMake: the page and the models' tests.
    const bool for_the_page = file.filename() == "drawing.hpp" || file.filename() == "models.hpp";
    const bool for_ones_own = file.filename() == "expect_failure.hpp";  // for exercises outside the tree
    INFO(name);
    CHECK((file.extension() != ".hpp" || for_the_page || for_ones_own || includers[name] >= 2));
  }
}

TEST_CASE("a scene's sources do without the claims' headers, whose changes would compile it again",
          "[rooms]") {
  const std::set<std::string> of_claims{"chapters/claims.hpp", "chapters/formulas.hpp",
                                        "chapters/provable_claims.hpp"};
  // As CMake distinguishes claims and proofs from scenes.
  const std::string cmake = oddity::read_whole(fs::path(ODDITY_SOURCE) / "CMakeLists.txt");
  std::smatch filter;
  REQUIRE(std::regex_search(cmake, filter, std::regex("claim_files INCLUDE REGEX \"/[(]([^)]+)[)]")));
  const std::regex claims_or_proofs(filter[1].str()), exercise("chapters/([0-9][0-9])_[^/]*/([0-9][0-9])_.*");
  int scenes = 0;
  for (const fs::path& file : sources("chapters")) {
    if (file.extension() != ".cpp" || std::regex_match(file.stem().string(), claims_or_proofs)) continue;
    const std::string name = file.lexically_relative(ODDITY_SOURCE).generic_string();
    std::smatch number;
    // An exercise of one's own may have all in one file.
    if (std::regex_match(name, number, exercise) &&
        !oddity::of_the_book({std::stoi(number[1]), std::stoi(number[2])}))
      continue;
    ++scenes;
    std::set<std::string> seen;
    const std::string path = path_to(of_claims, name, seen);
    INFO(path << ": move the claims to a claims.cpp of the exercise's folder");
    CHECK(path.empty());
  }
  CHECK(scenes > 48);
}

TEST_CASE("the vocabulary needs the standard library only", "[rooms]") {
  const fs::path vocabulary = fs::path(ODDITY_SOURCE) / "chapters" / "exercise.hpp";
  std::set<std::string> files{"chapters/exercise.hpp"};
  files.merge(ours(vocabulary));
  CHECK(files ==
        std::set<std::string>{"chapters/exercise.hpp", "solvers/ode/stability.hpp", "solvers/solved.hpp"});
  for (const std::string& file : files) {
    INFO(file);
    const fs::path path = fs::path(ODDITY_SOURCE) / file;
    CHECK((file == "chapters/exercise.hpp" || ours(path).empty()));
    for (const std::string& included : others(path)) CHECK(included.find('/') == std::string::npos);
  }
}

TEST_CASE("formulas need the standard library only", "[rooms]") {
  for (const fs::path& file : sources("formula"))
    for (const std::string& included : others(file)) {
      INFO(file.string() << " includes " << included);
      CHECK(included.find_first_of("/.") == std::string::npos);
    }
}

TEST_CASE("exercises do not print, test, look at a clock or draw from the library's distributions",
          "[rooms]") {
  const std::set<std::string> forbidden{"iostream", "cstdio", "print",           "chrono",
                                        "ctime",    "random", "catch2/catch.hpp"};
  for (const fs::path& file : sources("chapters"))
    for (const std::string& included : others(file)) {
      INFO(file.string() << " includes " << included);
      CHECK(forbidden.count(included) == 0);
    }
}
