#include <fstream>
#include <optional>
#include <regex>
#include <sstream>

#include "reference/bad_input.hpp"
#include "report/pages/cheapest_models_view.hpp"
#include "report/pages/markdown.hpp"
#include "report/pages/stability_view.hpp"
#include "report/pages/write_report.hpp"
#include "report/study/cheapest_models.hpp"
#include "report/study/stability.hpp"
#include "report/text/markup.hpp"
#include "report/verify/catch.hpp"
#include "tests/hostile.hpp"
#include "tests/sample_results.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
namespace fs = std::filesystem;
using hostile::Json;

namespace {

/// Markdown without escaped text, code and formulas: only markup is left.
std::string markup_of(const std::string& line) {
  std::string out;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t fence = std::min(line.find_first_not_of('`', at), line.size()) - at;
    const std::size_t end = fence > 0 ? line.find(std::string(fence, '`'), at + fence) : std::string::npos;
    if (line[at] == '\\') {
      at += 2;
    } else if (end != std::string::npos) {
      const std::string code = line.substr(at, end - at);
      for (std::size_t i = 0; i < code.size(); ++i)  // a table's bars are found before its code
        if (code[i] == '|' && code[i - 1] != '\\') out += '|';
      at = end + fence;
    } else {
      out += line[at++];
    }
  }
  return out;
}

/// Parts of a page that have broken out of their place.
std::vector<std::string> broken_out(const std::string& page) {
  std::vector<std::string> wrong;
  std::istringstream lines(page);
  long bars = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::string markup = markup_of(line);
    static const std::regex own(
        "<br>|<a id=\"[A-Za-z0-9._-]*\"></a>|</details>|<details><summary>([0-9]+ [a-z ]*|"
        "<b>[A-Za-z0-9. ]*</b>[A-Za-z0-9:, ]*)</summary>");
    const std::string foreign = std::regex_replace(markup, own, "");
    if (foreign.find('<') != std::string::npos) wrong.push_back("a tag: " + line);
    if (markup.find("](javascript") != std::string::npos) wrong.push_back("a link: " + line);
    if (line.find("INJECTED") < 5 && markup.find_first_of("#>-") < 4) wrong.push_back("a block: " + line);
    for (char c : line)
      if (static_cast<unsigned char>(c) < 0x20) wrong.push_back("a control character: " + line);
    const long now = line.starts_with('|') ? std::ranges::count(markup, '|') : 0;
    if (bars != 0 && now != 0 && now != bars) wrong.push_back("a cell: " + line);
    bars = now;
  }
  return wrong;
}

Json sample_as_json() { return Json::parse(to_json(sample())); }

/// Results with these strings replaced; nullopt if that gives no valid results file.
std::optional<Results> sample_with(const std::string& text, const hostile::Places& places) {
  try {
    return results_from_json(hostile::spoilt(sample_as_json(), places, text).dump(), "here");
  } catch (const BadInput&) {
    return std::nullopt;
  }
}

/// Makes pages with each string replaced in turn. Returns how many could be.
int pages_with(const std::string& text) {
  int written = 0;
  for (const auto& place : hostile::strings_of(sample_as_json()))
    if (const auto results = sample_with(text, {place})) {
      ++written;
      INFO(place.to_string() << " = " << text);
      for (const std::string& page :
           {index_page(*results), exercise_page_text(*results, results->exercises[0]),
            errata_page_text(*results), single_page(*results), times_page(*results),
            cheapest_models_page(*results), stability_page(*results), charts_page(results->exercises[0])})
        CHECK(broken_out(page) == std::vector<std::string>());
    }
  return written;
}

/// Writes reports into `out` with all the strings of one key replaced. Returns how many could be.
int reports_with(const std::string& text, const fs::path& out) {
  int written = 0;
  for (const auto& [key, same] : hostile::by_key(hostile::strings_of(sample_as_json())))
    if (const auto results = sample_with(text, same)) {
      ++written;
      INFO(key << " = " << text);
      fs::remove_all(out);
      write_report(*results, Edition::whole, out);
      for (const auto& file : fs::recursive_directory_iterator(out)) {
        const std::string page = file.is_regular_file() ? text_of(file.path()) : "";
        if (file.path().extension() == ".md") CHECK(broken_out(page) == std::vector<std::string>());
        if (file.path().extension() == ".svg") CHECK(page.find("<script") == std::string::npos);
        CHECK(file.path().extension() != ".part");
      }
      CHECK(std::distance(fs::directory_iterator(out.parent_path()), fs::directory_iterator()) == 1);
    }
  return written;
}

}  // namespace

TEST_CASE("no string of a results file is executed or breaks out of its place", "[report]") {
  const ScratchFolder scratch;
  const std::string canary = (scratch.path() / "canary").string();
  const std::string text = "`touch " + canary + "` $(touch " + canary + ") '; system('touch " + canary +
                           "') # \" \\ | @x %s {/:Bold <script>alert(1)</script> [x](javascript:alert(1))" +
                           "\n\n# INJECTED\n| a | b |\nEOD\n../../x\x01\x1b[31m\xc2\xb5 \\";
  CHECK(reports_with(text, scratch.path() / "out") > 15);
  CHECK(pages_with(text) > 50);
  for (const std::string& other : std::vector<std::string>{
           "# INJECTED", "- INJECTED", "\n# INJECTED", "|touch " + canary, "$|x|\\|y\\|`<script>$",
           "$ <script>", "`$<script>`$", "\\|", "a\\", "$\\$ <script>", ""})
    CHECK(pages_with(other) > 50);
}

TEST_CASE("no folder's name is executed or breaks out of its place", "[report]") {
  const ScratchFolder scratch;
  for (const std::string name : {"it's", "`touch canary`", "$(touch canary)", "|touch canary", "a\"b", "a b",
                                 "new\nline", "-d", "~root", "@x", "%s", "a\\", "a;touch canary", "µ"}) {
    INFO(name);
    write_charts(sample(), Curves::few, scratch.path() / "out" / name);
    CHECK(fs::exists(scratch.path() / "out" / name / "charts" / "3.5_q_motion.svg"));
    fs::remove_all(scratch.path() / "out" / name);
    CHECK(fs::is_empty(scratch.path() / "out"));
  }
  CHECK_FALSE(fs::exists("canary"));
}

TEST_CASE("text, formulas and code are written so that Markdown shows them", "[report]") {
  CHECK(escaped("a_1 < b & c [d] \\e | f\ng") == "a\\_1 \\< b \\& c \\[d\\] \\\\e \\| f g");
  CHECK(escaped("a | b", false) == "a | b");
  CHECK(escaped("so $a\\,b_1$ is") == "so $`a\\,b_1`$ is");
  CHECK(escaped("$|x|$ and $\\|x\\|$") == "$`\\vert x\\vert `$ and $`\\Vert x\\Vert `$");
  CHECK(escaped("$|x|$", false) == "$`|x|`$");
  CHECK(escaped("5 $ and `x") == "5 \\$ and \\`x");
  CHECK(escaped("`R.Dot(U)` is *it*") == "`R.Dot(U)` is \\*it\\*");
  CHECK(prose("`a_b` is *it*, $c_1$") == "`a_b` is *it*, $`c_1`$");
  CHECK(code("a`b") == "`` a`b ``");
  CHECK(file_name("../a b\n'c'") == "_._a_b__c_");
  CHECK(in_xml("a < b & \"c\" > 'd'\n") == "a &lt; b &amp; &quot;c&quot; &gt; 'd' ");
  CHECK(table({"h"}, {{"a|b\nc"}, {"a\\|b"}, {"a\\\\|b"}}) ==
        "| h |\n|---|\n| a\\|b c |\n| a\\|b |\n| a\\\\\\|b |\n\n");
}

TEST_CASE("powers and units are printed in the usual notation", "[report]") {
  CHECK(with_powers("4.4e-16 of 1e+06, e-1") == "4.4×10⁻¹⁶ of 1×10⁶, e-1");
  CHECK(typeset_unit("AU^3/(yr^2 solar mass)") == "AU³/(yr² solar mass)");
  CHECK(typeset_unit("sqrt(L/2g)") == "√(L/2g)");
  CHECK(typeset_unit("2^-500 m") == "2⁻⁵⁰⁰ m");
  CHECK(typeset_unit("N s/m") == "N s/m");
}
