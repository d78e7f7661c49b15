// The pages for readers of the repository: their links, their length, and the counts that they state.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "reference/csv.hpp"
#include "reference/verdicts.hpp"
#include "report/verify/catch.hpp"
#include "tests/scratch_folder.hpp"

namespace fs = std::filesystem;

namespace {

const fs::path tree = ODDITY_SOURCE;

/// All pages except those written by the program.
std::vector<fs::path> pages() {
  std::vector<fs::path> found{tree / "README.md", tree / "ARCHITECTURE.md", tree / "CONTRIBUTING.md"};
  for (const char* room : {"chapters", "cmake", "docs", "extras", "reference", "report", "solvers", "tests"})
    for (auto entry = fs::recursive_directory_iterator(tree / room);
         entry != fs::recursive_directory_iterator(); ++entry) {
      if (entry->path().filename() == "node_modules" || entry->path() == tree / "report/book")
        entry.disable_recursion_pending();
      else if (entry->path().extension() == ".md" && entry->path() != tree / "report/engines.md")
        found.push_back(entry->path());
    }
  return found;
}

/// The page without its blocks of code.
std::string prose_of(const fs::path& page) {
  std::istringstream in(text_of(page));
  std::string prose;
  bool is_code = false;
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("```"))
      is_code = !is_code;
    else if (!is_code)
      prose += line + "\n";
  return prose;
}

/// The words of a text with one space between them.
std::string words_of(const std::string& text) {
  std::istringstream in(text);
  std::string words;
  for (std::string word; in >> word;) words += word + " ";
  return words;
}

/// The anchors of a page's headings, as GitHub makes them.
std::set<std::string> anchors_of(const fs::path& page) {
  std::istringstream in(prose_of(page));
  std::set<std::string> anchors;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("#")) continue;
    std::string anchor;
    for (const char c : line.substr(line.find_first_not_of("# ")))
      if (c == ' ')
        anchor += '-';
      else if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_')
        anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    anchors.insert(anchor);
  }
  return anchors;
}

}  // namespace

TEST_CASE("every link of the pages leads somewhere", "[texts]") {
  const std::regex link(R"(\]\(([^)#]*)(#([^)]*))?\))");
  int links = 0;
  for (const fs::path& page : pages()) {
    const std::string prose = prose_of(page);
    for (std::sregex_iterator found(prose.begin(), prose.end(), link), end; found != end; ++found, ++links) {
      INFO(page.string() << ": " << found->str());
      const fs::path target = (*found)[1].length() == 0 ? page : page.parent_path() / (*found)[1].str();
      CHECK(fs::exists(target));
      if ((*found)[3].matched && target.extension() == ".md")
        CHECK(anchors_of(target).contains((*found)[3].str()));
    }
  }
  CHECK(links > 100);
}

TEST_CASE("the files named in the pages' tables exist", "[texts]") {
  const std::regex named(R"(`([a-z0-9_./]+\.(cpp|hpp|csv|cmake|mjs|js|json|sh|gp))`)");
  for (const fs::path& page : pages()) {
    if (page.filename() != "README.md") continue;
    std::istringstream in(prose_of(page));
    for (std::string line; std::getline(in, line);) {
      if (!line.starts_with("| `")) continue;
      const std::string first = line.substr(0, line.find(" |", 2));
      for (std::sregex_iterator found(first.begin(), first.end(), named), end; found != end; ++found) {
        const fs::path file = (*found)[1].str();
        INFO(page.string() << ": " << file.string());
        const fs::path room = page.parent_path();
        CHECK((fs::exists(room / file) || fs::exists(room / "approved" / file) || fs::exists(tree / file)));
      }
    }
  }
}

TEST_CASE("the introduction is short", "[texts]") {
  const std::string first = text_of(tree / "README.md");
  CHECK(std::ranges::count(first, '\n') <= 150);
  CHECK(fs::file_size(tree / "ARCHITECTURE.md") <= 8192);
  CHECK(fs::file_size(tree / "CONTRIBUTING.md") <= 10240);
}

TEST_CASE("the first page has the recorded counts", "[texts]") {
  const std::string page = words_of(text_of(tree / "README.md"));
  std::map<std::string, int> count;
  const auto verdicts = oddity::read_verdicts(tree / "reference/approved");
  for (const auto& [claim, verdict] : verdicts) ++count[verdict];
  std::ostringstream counts;
  counts << "The manual makes " << verdicts.size() << " claims: **" << count["confirmed"]
         << " are confirmed, " << count["wrong"] << " wrong, " << count["incomplete"] << " incomplete and "
         << count["misprint"] << " misprints**. Our plain-text copy has lost parts of another "
         << count["lost in our copy"] << ", which is no fault of the book. " << count["not checkable"]
         << " cannot be checked from the text. ";
  INFO(counts.str());
  CHECK(page.find(counts.str()) != std::string::npos);

  const std::string trust = text_of(tree / "report/book/trust.md");
  std::smatch proved;
  REQUIRE(std::regex_search(trust, proved, std::regex(R"(\*\*proved\*\*: (\d+) of)")));
  CHECK(page.find(proved[1].str() + " proofs by Coq") != std::string::npos);
}

TEST_CASE("the output of trust shown in the README agrees with its page", "[texts]") {
  const std::string shown = text_of(tree / "report/README.md"), page = text_of(tree / "report/book/trust.md");
  const std::regex line(R"(\n  ([a-z]+) +(\d+ of \d+) )");
  const std::size_t begin = shown.find("$ ./oddity trust");
  REQUIRE(begin != std::string::npos);
  const std::string block = shown.substr(begin, shown.find("```", begin) - begin);
  int lines = 0;
  for (std::sregex_iterator found(block.begin(), block.end(), line), end; found != end; ++found, ++lines) {
    INFO(found->str());
    CHECK(page.find("**" + (*found)[1].str() + "**: " + (*found)[2].str() + " ") != std::string::npos);
  }
  CHECK(lines > 3);
}

TEST_CASE("the findings on the first page have the numbers of their pages", "[texts]") {
  const std::string page = text_of(tree / "README.md");
  const std::regex row(R"(\n\| (\d+\.\d+) \|([^\n]*))"), number(R"(\d+\.\d+|\d\d+)");
  int rows = 0;
  for (std::sregex_iterator found(page.begin(), page.end(), row), end; found != end; ++found, ++rows) {
    const std::string exercise = (*found)[1].str(), says = (*found)[2].str();
    const std::string has = text_of(tree / "report/book" / (exercise + ".md"));
    for (std::sregex_iterator shown(says.begin(), says.end(), number); shown != end; ++shown) {
      INFO(exercise << " has " << shown->str());
      CHECK(std::regex_search(
          has, std::regex("(^|[^0-9.])" + std::regex_replace(shown->str(), std::regex(R"(\.)"), "\\.") +
                          "([^0-9]|$)")));
    }
  }
  CHECK(rows > 3);
  CHECK(text_of(tree / "report/book/models.md").find("*small angle* is enough for `a` up to 0.211 rad") !=
        std::string::npos);
}

TEST_CASE("no engine follows the heavy top by its defaults, as the first page states", "[texts]") {
  std::istringstream in(text_of(tree / "report/engines.md"));
  std::ptrdiff_t column = -1;
  int engines = 0;
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, '|');) cells.push_back(cell);
    const auto top =
        std::ranges::find_if(cells, [](const std::string& cell) { return cell.starts_with(" [3.33]"); });
    if (column >= 0 && line.empty()) break;
    if (top != cells.end()) column = top - cells.begin();
    if (column < 0 || static_cast<std::size_t>(column) >= cells.size()) continue;
    double degrees = 0;
    if (!(std::istringstream(cells[static_cast<std::size_t>(column)]) >> degrees)) continue;
    INFO(cells[1] << ": " << degrees);
    CHECK(degrees > 1);
    ++engines;
  }
  CHECK(engines > 3);
}

TEST_CASE("the first page names four of the engines and counts the others", "[texts]") {
  const std::string in_double = " in double", page = words_of(text_of(tree / "README.md"));
  std::set<std::string> engines;
  for (const oddity::CsvRow& row : oddity::read_csv(tree / "reference/approved/engines.csv").rows)
    if (!row.cells[1].ends_with(in_double)) engines.insert(row.cells[1]);
  CHECK(engines.size() == 4 + 7);
  CHECK(page.find("Bullet, Box2D, Jolt, MuJoCo and seven other engines") != std::string::npos);
}
