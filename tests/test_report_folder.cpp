#include <algorithm>
#include <cctype>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "reference/verdicts.hpp"
#include "report/pages/write_report.hpp"
#include "report/verify/catch.hpp"
#include "tests/sample_results.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
namespace fs = std::filesystem;

namespace {

using Lines = std::vector<std::string>;

std::vector<fs::path> pages_in(const fs::path& folder) {
  std::vector<fs::path> pages;
  for (const auto& file : fs::directory_iterator(folder))
    if (file.path().extension() == ".md") pages.push_back(file.path());
  return pages;
}

/// GitHub's anchor of a heading.
std::string anchor_of_heading(const std::string& heading) {
  std::string anchor;
  for (char c : heading) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isalnum(letter) != 0 || letter >= 0x80 || c == '_' || c == '-')
      anchor += static_cast<char>(letter < 0x80 ? std::tolower(letter) : c);
    else if (c == ' ')
      anchor += '-';
  }
  return anchor;
}

std::set<std::string> anchors_of(const std::string& page) {
  std::set<std::string> anchors;
  static const std::regex id("<a id=\"([^\"]*)\"></a>");
  for (std::sregex_iterator found(page.begin(), page.end(), id), none; found != none; ++found)
    anchors.insert(found->str(1));
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);)
    if (const auto level = line.find_first_not_of('#');
        level != 0 && level != std::string::npos && line[level] == ' ')
      anchors.insert(anchor_of_heading(line.substr(level + 1)));
  return anchors;
}

/// Links of a report's pages to missing targets, and pictures that no page shows.
Lines broken_links(const fs::path& folder) {
  Lines broken;
  std::map<fs::path, std::set<std::string>> anchors;
  std::set<fs::path> pictures;
  for (const fs::path& page : pages_in(folder)) anchors[page] = anchors_of(text_of(page));
  static const std::regex link("\\]\\(([^)#]*)(#([^)]*))?\\)");
  for (const fs::path& page : pages_in(folder)) {
    const std::string text = text_of(page);
    for (std::sregex_iterator found(text.begin(), text.end(), link), none; found != none; ++found) {
      const fs::path to = found->length(1) == 0 ? page : folder / found->str(1);
      const bool there = fs::exists(to) && (found->length(3) == 0 || anchors[to].contains(found->str(3)));
      if (!there) broken.push_back(page.filename().string() + ": " + found->str());
      pictures.insert(to);
    }
  }
  for (const auto& file : fs::directory_iterator(folder / "charts"))
    if (!pictures.contains(file.path())) broken.push_back("shown nowhere: " + file.path().string());
  return broken;
}

std::size_t words_of(const fs::path& folder) {
  std::size_t words = 0;
  for (const fs::path& page : pages_in(folder)) {
    std::istringstream in(text_of(page));
    for (std::string word; in >> word;) ++words;
  }
  return words;
}

std::uintmax_t bytes_within(const fs::path& folder) {
  std::uintmax_t bytes = 0;
  for (const auto& file : fs::recursive_directory_iterator(folder))
    if (file.is_regular_file()) bytes += file.file_size();
  return bytes;
}

const fs::path book = fs::path(ODDITY_SOURCE) / "report" / "book";

}  // namespace

TEST_CASE("all links of a report lead somewhere, and every picture is shown", "[report]") {
  const ScratchFolder scratch;
  for (Edition edition : {Edition::whole, Edition::book}) {
    const fs::path folder = scratch.path() / (edition == Edition::book ? "book" : "whole");
    CHECK(write_report(sample(), edition, folder) == folder / "README.md");
    CHECK(broken_links(folder) == Lines());
    CHECK(fs::exists(folder / "times.md") == (edition == Edition::whole));
  }
  CHECK(broken_links(book) == Lines());
}

TEST_CASE("dead links are found", "[report]") {
  const ScratchFolder scratch;
  fs::create_directories(scratch.path() / "charts");
  scratch.file("charts/b.svg", "");
  scratch.file("a.md", "# A heading, 2\n[x](#a-heading-2) [x](a.md#other) [x](none.md) ![x](charts/a.svg)\n");
  CHECK(broken_links(scratch.path()).size() == 4);
}

TEST_CASE("the book is short enough to read", "[report]") {
  // Counted like wc -w. The whole report also has the engines' page and one of times.
  constexpr std::size_t times = 1'750;
  CHECK(words_of(book) + words_of(book.parent_path()) + times <= 65'000);
  CHECK(bytes_within(book) <= 8'000'000);
}

TEST_CASE("the book has a page for each exercise, which lists each erratum and misprint once", "[report]") {
  const std::string errata = text_of(book / "errata.md");
  for (const Entry& entry : registry())
    if (of_the_book(entry.number)) CHECK(fs::exists(book / exercise_file(entry.number)));
  const Verdicts on_record = read_verdicts(fs::path(ODDITY_SOURCE) / "reference" / "approved");
  int wrong = 0;
  for (const auto& [id, verdict] : on_record) {
    if (verdict == "confirmed" || verdict == "not checkable") continue;
    ++wrong;
    const std::string file = id.substr(0, id.find('-')) + ".md", page = text_of(book / file);
    INFO(id);
    const std::string anchor = "<a id=\"" + id + "\"></a>";
    CHECK(page.find(anchor) != std::string::npos);
    CHECK(page.find(anchor) == page.rfind(anchor));
    const std::string link = "(" + file + "#" + id + ")";
    CHECK(errata.find(link) != std::string::npos);
    CHECK(errata.find(link) == errata.rfind(link));
  }
  CHECK(wrong > 100);
}
