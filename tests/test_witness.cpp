// Compares the recorded results of PARI/GP on the errata (reference/witness) with those of the suite.
// tests/witness.sh repeats them with gp.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "chapters/contents.hpp"
#include "reference/csv.hpp"
#include "reference/reference.hpp"
#include "reference/text.hpp"
#include "reference/verdicts.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

const std::filesystem::path tables = std::filesystem::path(ODDITY_SOURCE) / "reference";

/// A row of witness.csv.
struct Witness {
  std::string claim, seen, check, at, right, printed;
};

std::vector<Witness> witnesses() {
  std::vector<Witness> all;
  for (const CsvRow& row : read_csv(tables / "witness/witness.csv").rows) {
    const auto& c = row.cells;
    all.push_back({c[0], c[1], c[2], c[3], c[4], c[5]});
  }
  return all;
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

/// The numbers of a text; empty if one of its words is not a number.
std::vector<double> numbers(const std::string& text) {
  std::vector<double> all;
  for (const std::string& word : words(text))
    if (const auto x = parse_number(word))
      all.push_back(*x);
    else
      return {};
  return all;
}

/// "worst of 50: $r$ = 1.5, $T$ = 2, on the orbit": 1.5 and 2.
std::vector<double> letters(std::string_view where) {
  std::vector<double> all;
  for (auto i = where.find(" = "); i != where.npos; i = where.find(" = ", i)) {
    i += 3;
    const auto end = std::min(where.find(',', i), where.size());
    if (const auto x = parse_number(where.substr(i, end - i))) all.push_back(*x);
  }
  return all;
}

/// Agreement to ten digits of the largest component; a text without numbers agrees with a value that is not
/// finite.
bool agree(const std::string& said, const Value& computed) {
  const Value value = numbers(said);
  if (value.size() == 0) return !finite(computed);
  return distance(value, computed) <= 1e-10 * size_of(value);
}

class Suite {
 public:
  const Claim& claim(const std::string& id) {
    const std::string exercise = id.substr(0, id.find('-'));
    auto& claims = studied_[exercise];
    if (claims.empty()) claims = study(exercise);
    return *std::ranges::find(claims, id, &Claim::id);
  }

 private:
  static std::vector<Claim> study(const std::string& exercise) {
    for (const Entry& entry : registry())
      if (to_string(entry.number) == exercise)
        return entry.exercise.study(Parameters(entry.exercise.parameters), Reference(tables)).claims;
    throw std::logic_error("no exercise " + exercise);
  }

  std::map<std::string, std::vector<Claim>> studied_;
};

/// "printed 2": the second check of the printed reading.
const Check& check_of(const Claim& claim, const std::string& name) {
  const Reading& reading = name.starts_with("printed ") ? claim.printed : claim.corrected;
  return reading.checks.at(static_cast<std::size_t>(name.back() - '1'));
}

}  // namespace

TEST_CASE("every erratum has a witness, or a reason why it has none", "[witness]") {
  std::set<std::string> errata, heard;
  for (const auto& [claim, verdict] : read_verdicts(tables / "approved"))
    if (verdict == "wrong" || verdict == "incomplete") errata.insert(claim);
  for (const Witness& witness : witnesses()) heard.insert(witness.claim);
  for (const CsvRow& row : read_csv(tables / "witness/words.csv").rows)
    CHECK(heard.insert(row.cells[0]).second);
  CHECK(heard == errata);
}

TEST_CASE("the suite's numbers agree with the witness's to ten digits", "[witness]") {
  Suite suite;
  for (const Witness& witness : witnesses()) {
    if (witness.check.empty()) continue;
    const Check& check = check_of(suite.claim(witness.claim), witness.check);
    INFO(witness.claim << " at " << check.where
                       << ": give the script in reference/witness these letters, and run "
                       << "tests/witness.sh --write");
    CHECK(letters(check.where) == numbers(witness.at));
    // Some checks have the right value on their left.
    const bool turned = !agree(witness.right, check.right.value);
    const Value& right = turned ? check.left.value : check.right.value;
    const Value& printed = turned ? check.right.value : check.left.value;
    CHECK(agree(witness.right, right));
    if (witness.seen == "both") CHECK(agree(witness.printed, printed));
    CHECK(!agree(witness.printed, right));
  }
}

TEST_CASE("a wrong digit of a witness is noticed", "[witness]") {
  CHECK(agree("1.25 -3", Value{1.25, -3}));
  CHECK(!agree("1.25 -3", Value{1.25, -3.000000001}));
  CHECK(!agree("1.25", Value{1.25, -3}));
  CHECK(!agree("none", Value(1.25)));
  CHECK(!agree("1.25", Value(NAN)));
  CHECK(letters(R"(worst of 9: $r$ = 1.5, $\omega$ = -2e-3, on the orbit)") == std::vector{1.5, -2e-3});
}
