#include "tests/libraries/shown.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "reference/text.hpp"
#include "report/verify/catch.hpp"
#include "solvers/ode/catalog.hpp"

namespace fs = std::filesystem;
using oddity::ode::Finding, oddity::ode::findings;

void Shown::check(const std::string& words, bool hold, double measured) const {
  std::string installed = version;
  std::ranges::replace(installed, '_', '.');
  const auto finding = std::ranges::find(findings(), by, &Finding::shown_by);
  REQUIRE(finding != findings().end());
  INFO(by << ", \"" << words << "\": measured " << oddity::format_significant(measured, 3) << " with "
          << finding->library << " " << installed);
  CHECK(finding->found.find(words) != std::string_view::npos);
  if (installed == finding->version)
    CHECK(hold);
  else
    WARN((hold ? "still so: " : "no longer so: ") << "found in version " << finding->version);
}

TEST_CASE("every finding about a library has its test, and every test its finding", "[libraries]") {
  std::vector<std::string> files, stated;
  for (const auto& file : fs::directory_iterator(fs::path(ODDITY_SOURCE) / "tests" / "libraries"))
    if (file.path().extension() == ".cpp" && file.path().stem() != "shown") {
      files.push_back(file.path().stem().string());
      std::ifstream in(file.path());
      const std::string text(std::istreambuf_iterator<char>(in), {});
      INFO(files.back());
      CHECK(text.find("Shown shown{\"" + files.back() + "\"") != std::string::npos);
    }
  for (const Finding& f : findings()) {
    stated.emplace_back(f.shown_by);
    for (std::string_view text : {f.library, f.version, f.in, f.found, f.done}) CHECK_FALSE(text.empty());
  }
  std::ranges::sort(files);
  std::ranges::sort(stated);
  CHECK(files == stated);
}
