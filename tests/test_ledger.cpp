// The ledger of the solutions' assertions, compared with the claims that judge them.

#include "reference/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

#include "chapters/claims.hpp"
#include "chapters/contents.hpp"
#include "reference/csv.hpp"
#include "reference/reference.hpp"
#include "reference/verdicts.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;

namespace {

const std::string tables = std::string(ODDITY_SOURCE) + "/reference";

std::string said_of(const std::string& rows) {
  const ScratchFolder folder;
  folder.file("ledger/1.1.csv", "line,place,assertion,claims,reason\n" + rows);
  const std::string all = complaint([&] { read_ledger(folder.path(), "1.1"); });
  return all.substr(std::min(all.size(), all.find(".csv") + 4));
}

}  // namespace

TEST_CASE("a ledger is read, and a row without content is refused", "[ledger]") {
  const ScratchFolder folder;
  folder.file(
      "ledger/1.1.csv",
      "line,place,assertion,claims,reason\n7,first display,x is 1,x one,\n8,second display,y,,a definition\n");
  const auto all = read_ledger(folder.path(), "1.1");
  REQUIRE(all.size() == 2);
  CHECK(all[0].claims == std::vector<std::string>{"1.1-x", "1.1-one"});
  CHECK(all[0].line == 7);
  CHECK(all[1].reason == "a definition");
  CHECK(read_ledger(folder.path(), "1.3").empty());
  CHECK(said_of("7,,x is 1,x,\n") == ":2: an assertion needs a place and a text");
  CHECK(said_of("7,here,x is 1,,\n") == ":2: an assertion has claims, or a reason why it has none");
  CHECK(said_of("7,here,x is 1,x,so\n") == ":2: an assertion has claims, or a reason why it has none");
}

TEST_CASE("every exercise has a ledger: each assertion has claims or a reason, and each claim its assertion",
          "[ledger]") {
  const Verdicts approved = read_verdicts(tables + "/approved");
  for (const Entry& entry : registry()) {
    if (!of_the_book(entry.number)) continue;
    const std::string number = to_string(entry.number);
    const auto ledger = read_ledger(tables, number);
    INFO(number);
    REQUIRE_FALSE(ledger.empty());
    CHECK(std::ranges::is_sorted(ledger, {}, &Assertion::line));
    std::set<std::string> judged;
    for (const Assertion& assertion : ledger) {
      judged.insert(assertion.claims.begin(), assertion.claims.end());
      INFO(assertion.assertion << ": an assertion that is judged elsewhere has that claim, not a reason");
      CHECK_FALSE(std::regex_search(assertion.reason, std::regex("repeat|judged")));
    }
    for (const std::string& claim : judged) {
      INFO(claim << " is in the ledger");
      CHECK(approved.contains(claim));
    }
    for (const auto& [claim, verdict] : approved) {
      if (!claim.starts_with(number + "-")) continue;
      INFO(claim << " is a claim");
      CHECK(judged.contains(claim));
    }
  }
}

TEST_CASE("a claim's line is that of one of its assertions in the ledger", "[ledger]") {
  const Reference truth(tables);
  for (const Entry& entry : registry()) {
    const auto ledger = read_ledger(tables, to_string(entry.number));
    if (!of_the_book(entry.number) || ledger.empty()) continue;
    for (const Claim& claim : entry.exercise.study(Parameters(entry.exercise.parameters), truth).claims) {
      INFO(claim.id << " is in the ledger, at its line " << claim.line);
      CHECK(std::ranges::any_of(ledger, [&](const Assertion& assertion) {
        return assertion.line == claim.line && std::ranges::count(assertion.claims, claim.id) > 0;
      }));
    }
  }
}

TEST_CASE("a misprint is right elsewhere in the solution: in a confirmed claim or on another line",
          "[ledger]") {
  const Verdicts approved = read_verdicts(tables + "/approved");
  std::set<std::string> shown;
  for (const CsvRow& row : read_rows(tables + "/meant.csv", {"misprint", "shown_by"}, 1)) {
    const std::string &misprint = row.cells[0], &by = row.cells[1];
    INFO(row.place << ": " << misprint << " by " << by);
    CHECK(shown.insert(misprint).second);
    REQUIRE(approved.contains(misprint));
    CHECK(approved.at(misprint) == "misprint");
    const std::string exercise = misprint.substr(0, misprint.find('-'));
    if (by.starts_with("line ")) {
      CHECK(std::ranges::any_of(read_ledger(tables, exercise), [&](const Assertion& assertion) {
        return "line " + std::to_string(assertion.line) == by &&
               std::ranges::count(assertion.claims, misprint) == 0;
      }));
    } else {
      CHECK(by.starts_with(exercise + "-"));
      REQUIRE(approved.contains(by));
      CHECK(approved.at(by) == "confirmed");
    }
  }
  for (const auto& [claim, verdict] : approved) {
    INFO(claim << " is a misprint");
    CHECK((verdict != "misprint" || shown.contains(claim)));
  }
}

TEST_CASE("numbers are filled into a text, each in its place", "[claims]") {
  CHECK(filled("off by @2 m after @3 s", {0.1234, 12.345}) == "off by 0.12 m after 12.3 s");
  CHECK(filled("nothing", {}) == "nothing");
  CHECK(filled("$@1$, $-@2$, $@1$ and @1", {5e-11, 1.2e12, 1e-7, 1e-7}) ==
        R"($5\cdot10^{-11}$, $-1.2\cdot10^{12}$, $10^{-7}$ and 1e-07)");
  CHECK(filled("@2, $@2$, @1, @2 and @3", {4.0 / 3, -2.0 / 3, 0.75, 0.75, 1.333}) ==
        R"(4/3, $-\frac{2}{3}$, 3/4, 0.75 and 1.33)");
  CHECK(filled("@1, $@1$ and @2", {std::nextafter(2.0, 1.0), -std::nextafter(2.0, 3.0), 0.1 + 0.2}) ==
        "2, $-2$ and 0.3");
  CHECK_THROWS_AS(filled("@2", {}), std::logic_error);
  CHECK_THROWS_AS(filled("none", {1}), std::logic_error);
  CHECK_THROWS_AS(filled("@x", {1}), std::logic_error);
  CHECK_THROWS_AS(filled("@", {1}), std::logic_error);
}
