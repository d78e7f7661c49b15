// The tables' enclosures, computed again: they contain the printed digits, and exclude a wrong digit.

#ifdef ODDITY_ARB

#include "reference/enclosures/enclose.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <set>

#include "reference/csv.hpp"
#include "reference/in_long_double.hpp"
#include "report/verify/catch.hpp"
#include "tests/program.hpp"

using namespace oddity;

namespace {

struct Row {
  std::vector<double> inputs, errors;
  std::vector<std::string> decimals, bounds;
};

std::vector<Row> rows_of(const std::filesystem::path& file) {
  const CsvFile csv = read_csv(file);
  const auto& columns = csv.header.cells;
  const auto n = static_cast<std::size_t>(std::ranges::find(columns, "component") - columns.begin());
  std::vector<Row> rows;
  for (const CsvRow& line : csv.rows) {
    std::vector<double> inputs;
    for (std::size_t i = 0; i < n; ++i) inputs.push_back(line.number(i));
    if (rows.empty() || rows.back().inputs != inputs) rows.push_back({inputs, {}, {}, {}});
    rows.back().decimals.push_back(line.cells[n + 1]);
    rows.back().errors.push_back(line.number(n + 2));
    rows.back().bounds.push_back(line.cells[n + 3]);
  }
  return rows;
}

struct Table {
  std::string name;
  std::vector<Row> rows;
};

const std::vector<Table>& tables() {
  static const std::vector<Table> all = [] {
    std::vector<Table> read;
    for (const auto& file : std::filesystem::directory_iterator(ODDITY_SOURCE "/reference/tables"))
      read.push_back({file.path().stem().string(), rows_of(file.path())});
    return read;
  }();
  return all;
}

/// Friction has no Taylor series where the instantaneous center crosses an edge of the box. The slopes of the
/// chain's motion take hours.
const std::set<std::string> not_enclosed{"03_25_growth", "03_31_rest", "03_31_slide"};
/// Motions: an enclosure takes up to a minute.
const std::set<std::string> slow{"03_17_axis", "03_25_chain"};

bool has_motions(const std::string& table) {
  return slow.contains(table) ||
         std::set<std::string>{"03_05_swing", "03_11_hill", "03_13_chute", "03_15_slide", "03_17_bob",
                               "03_07_slide", "03_21_disk", "03_23_swing", "03_33_axis",  "03_35_axis"}
             .contains(table);
}

/// The decimal with one digit changed: this number, the first nonzero one being 1. It is one more or, for a
/// nine, one less.
std::string with_wrong_digit(std::string decimal, int number) {
  int seen = 0;
  for (char& c : decimal) {
    if (c == 'e') break;
    if (c < '0' || c > '9' || (seen == 0 && c == '0')) continue;
    if (++seen == number) {
      c = static_cast<char>(c == '9' ? '8' : c + 1);
      return decimal;
    }
  }
  return "";
}

std::vector<double> distances(const Table& table, const Row& row, const std::vector<std::string>& decimals) {
  const auto all = distances_from_exact(table.name, row.inputs, decimals);
  REQUIRE(all);
  return *all;
}

}  // namespace

TEST_CASE("every value is enclosed except those known not to be", "[enclosures]") {
  for (const Table& table : tables())
    for (const Row& row : table.rows) {
      INFO(table.name);
      for (std::size_t i = 0; i < row.bounds.size(); ++i) {
        CHECK(row.bounds[i] == (not_enclosed.contains(table.name) ? "agreement" : "enclosure"));
        const double size = std::abs(std::stod(row.decimals[i]));
        if (row.bounds[i] == "enclosure" && size > 1e-20) CHECK(row.errors[i] <= 1e-20 * size);
      }
    }
}

TEST_CASE("enclosures computed again contain the printed digits", "[enclosures]") {
  for (const Table& table : tables()) {
    if (not_enclosed.contains(table.name)) {
      CHECK_FALSE(distances_from_exact(table.name, table.rows.front().inputs, table.rows.front().decimals));
      continue;
    }
    if (slow.contains(table.name)) continue;
    const std::size_t rows = has_motions(table.name) ? 1 : table.rows.size();
    for (std::size_t k = 0; k < rows; ++k) {
      const auto all = distances(table, table.rows[k], table.rows[k].decimals);
      INFO(table.name << ", row " << k);
      for (std::size_t i = 0; i < all.size(); ++i) CHECK(all[i] <= table.rows[k].errors[i]);
    }
  }
}

TEST_CASE("no enclosure contains a wrong digit", "[enclosures]") {
  for (const Table& table : tables()) {
    if (not_enclosed.contains(table.name) || slow.contains(table.name)) continue;
    const Row& row = table.rows.front();
    const std::size_t last = row.decimals.size() - 1;
    for (int digit : {1, 9, 16, 20}) {
      auto decimals = row.decimals;
      decimals[last] = with_wrong_digit(row.decimals[last], digit);
      if (decimals[last].empty()) continue;  // a number of fewer digits
      INFO(table.name << ", digit " << digit << " of " << row.decimals[last]);
      CHECK(distances(table, row, decimals)[last] > row.errors[last]);
    }
  }
}

TEST_CASE("a table that does not exist has no enclosure", "[enclosures]") {
  CHECK_FALSE(distances_from_exact("03_05_nothing", {1}, {"1"}));
}

TEST_CASE("a motion computed on the spot is enclosed, and a wrong one is detected", "[enclosures]") {
  const std::vector<double> swing{0.7, 1, 9.81}, times{0.1, 0.5, 1, 5, 10};
  const Known known = Reference(ODDITY_SOURCE "/reference")
                          .to_digits(digits_in_long_double)
                          .motion("03_05_swing", swing, times);
  std::vector<double> values = known.value;
  const auto enclosed = [&] {
    return enclosed_on_demand({"03_05_swing", swing, times, values, digits_in_long_double}, {});
  };
  CHECK(enclosed().distance < 1e-14);
  CHECK(enclosed().distance > 0);
  values.back() += 1e-9;
  CHECK(enclosed().distance > 0.99e-9);
  CHECK(enclosed().distance < 1.01e-9);
}

TEST_CASE("an enclosure is computed to the requested digits", "[enclosures]") {
  const std::vector<double> at{0.7, 1, 9.81, 1}, none;
  const Known known = Reference(ODDITY_SOURCE "/reference")("03_05_swing", at);
  CHECK(enclosed_on_demand({"03_05_swing", at, none, known.value, 30}, {}).distance < 1e-16);
}

TEST_CASE("a motion without an enclosure is reported, and the wait can be ended", "[enclosures]") {
  const std::vector<double> at{1}, values{0}, times{1};
  const Enclosed none = enclosed_on_demand({"03_31_rest", at, times, values, 14}, {});
  CHECK(std::isinf(none.distance));
  CHECK(none.by == "not enclosed: its table has no route that encloses it");
  const std::vector<double> swing{0.7, 1, 9.81};
  CHECK_THROWS_AS(
      enclosed_on_demand({"03_05_swing", swing, times, values, 14}, [](double) { throw std::bad_alloc(); }),
      std::bad_alloc);
}

TEST_CASE("a choice reports how its reference is enclosed", "[enclosures]") {
  const program::Ran ran = program::run("choose 3.5 a=0.7 --error 0.01 --enclosed");
  CHECK(ran.status == 0);
  CHECK(program::says(ran, "enclosed by the second route, the remainders bounded"));
  CHECK(program::says(program::run("choose 3.31 --error 0.01 --horizon 0.5 --enclosed"), "not enclosed"));
  CHECK(program::says(program::run("solve 3.5 a=2.4 --enclosed"), "enclosed by"));
}

#else

#include "report/verify/catch.hpp"
#include "tests/program.hpp"

TEST_CASE("without Arb nothing is enclosed, and the program names the package", "[enclosures]") {
  const program::Ran ran = program::run("choose 3.5 --error 0.01 --enclosed");
  CHECK(ran.status == 2);
  CHECK(program::says(ran, "libflint-arb-dev"));
}

#endif
