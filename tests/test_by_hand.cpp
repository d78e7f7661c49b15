#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <string>

#include "chapters/contents.hpp"
#include "reference/csv.hpp"
#include "reference/reference.hpp"
#include "report/study/standing.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

const std::filesystem::path tables = std::filesystem::path(ODDITY_SOURCE) / "reference";

/// A formula, or several in a row.
bool is_formulas(const std::string& text) {
  static const std::regex formulas(R"(\$[^$]*\$(, (and )?\$[^$]*\$)*)");
  return std::regex_match(text, formulas);
}

/// The hardest of the generated changes, or one that holds.
bool is_generated(const Reading& near_miss) {
  return near_miss.text.find(", the hardest to see of ") != std::string::npos;
}

/// "reading", if it is not computed from its text; "near miss", if only one of these is not; or neither.
std::string by_hand(const Claim& claim) {
  if (!claim.printed.checks.empty() && stated_in(claim) != "words" && !is_formulas(claim.printed.text))
    return "reading";
  return std::ranges::all_of(claim.near_misses, is_generated) ? "" : "near miss";
}

/// Rows of by_hand.csv, by "3.5-value reading", "3.5 numbers near miss" or "all cases reading".
std::map<std::string, bool> reasons() {
  std::map<std::string, bool> asked;
  for (const CsvRow& row : read_csv(tables / "approved/by_hand.csv").rows) {
    INFO(row.place);
    REQUIRE(row.cells.size() == 4);
    const std::string stated = row.cells[1].empty() ? "" : row.cells[1] + " ";
    CHECK(asked.emplace(row.cells[0] + " " + stated + row.cells[2], false).second);
    CHECK_FALSE(row.cells[3].empty());
  }
  return asked;
}

}  // namespace

TEST_CASE("readings and near misses by hand have a recorded reason", "[claims]") {
  std::map<std::string, bool> asked = reasons();
  const Reference truth(tables);
  for (const Entry& entry : registry()) {
    if (!of_the_book(entry.number)) continue;
    for (const Claim& claim : entry.exercise.study(Parameters(entry.exercise.parameters), truth).claims) {
      const std::string part = by_hand(claim), stated = std::string(stated_in(claim)) + " " + part;
      if (part.empty()) continue;
      bool found = false;
      for (const std::string& row :
           {claim.id + " " + part, to_string(entry.number) + " " + stated, "all " + stated})
        if (const auto reason = asked.find(row); !found && reason != asked.end())
          found = reason->second = true;
      INFO(claim.id << ", " << part << ", stated in " << stated_in(claim)
                    << ": give it a row in reference/approved/by_hand.csv");
      CHECK(found);
    }
  }
  for (const auto& [row, is_asked] : asked) {
    INFO("no claim needs the row '" << row << "' of reference/approved/by_hand.csv: take it out");
    CHECK(is_asked);
  }
}
