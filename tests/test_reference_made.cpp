// How the tables are made, and that every tabulated value can be made again.

#include "reference/truth.hpp"

#include <execution>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "reference/reference.hpp"
#include "tests/catch.hpp"
#include "tests/near.hpp"

using namespace oddity;
namespace fs = std::filesystem;

namespace {

const fs::path tables = fs::path(ODDITY_SOURCE) / "reference";

using truth::Numbers, truth::Number;

truth::Truth two_routes(truth::Route first, truth::Route second) {
  return {"a test", "x", {"x"}, {{"x", "1"}}, {{1}}, "first", std::move(first), "second", std::move(second)};
}

truth::Route gives(const Number& x) {
  return [x](const std::vector<double>&, int) { return Numbers{x}; };
}

}  // namespace

TEST_CASE("a made row's error bounds the disagreement of its routes by a power of ten", "[reference]") {
  const auto error = [](const Number& first, const Number& second) {
    return truth::make_row(two_routes(gives(first), gives(second)), {1}, 30).error;
  };
  CHECK(error(1, 1) == pow(Number(10), -30));
  CHECK(abs(error(1000, 1000) / pow(Number(10), -27) - 1) < 1e-40);
  CHECK(error(1, Number("1.0000003")) == pow(Number(10), -6));
  CHECK(error(0, Number("3e-20")) == pow(Number(10), -19));
}

TEST_CASE("a route without a finite value makes no row", "[reference]") {
  const Number nan = std::numeric_limits<Number>::quiet_NaN(), inf = std::numeric_limits<Number>::infinity();
  for (const Number& bad : {nan, inf}) {
    CHECK_THROWS_AS(truth::make_row(two_routes(gives(bad), gives(1)), {1}, 24), std::domain_error);
    CHECK_THROWS_AS(truth::make_row(two_routes(gives(1), gives(bad)), {1}, 24), std::domain_error);
  }
  const truth::Route empty = [](const std::vector<double>&, int) { return Numbers{}; };
  CHECK_THROWS_AS(truth::make_row(two_routes(empty, gives(1)), {1}, 24), std::logic_error);
  CHECK_THROWS_AS(truth::make_row(two_routes(gives(1), empty), {1}, 24), std::logic_error);
}

TEST_CASE("a table's text is its provenance, its header and its rows", "[reference]") {
  CHECK(truth::table("00_00_test", two_routes(gives(Number(1) / 3), gives(Number(1) / 3))) ==
        "# a test\n"
        "# formula: x\n"
        "# made by: reference/make/00_00_test.cpp, working with 60 digits (MPFR)\n"
        "# first route: first\n"
        "# second route: second\n"
        "# error: bounds the disagreement of the two routes, rounded up to a power of ten\n"
        "# inputs: the double nearest to the decimal shown, taken as exact\n"
        "x,component,value,error,unit\n"
        "1,x,0.3333333333333333333333333333333333333333,1e-42,1\n");
}

TEST_CASE("a row made on the spot agrees with the table's", "[reference]") {
  const Reference stored(tables);
  for (const truth::Entry& entry : truth::registry()) {
    const std::string name(entry.name);
    if (name != "03_05_quarter_period" && name != "03_05_swing") continue;
    const truth::Truth maker = entry.make();
    for (const auto& inputs : maker.rows) {
      const truth::Made made = truth::make_row(maker, inputs, truth::spot_digits);
      const Known known = stored(name, inputs);
      CHECK(near(static_cast<double>(made.value[0]), known.value[0], known.error));
      CHECK(made.error < 1e-22);
    }
  }
}

namespace {

struct TableText {
  std::string provenance, header;
  std::vector<std::vector<std::string>> rows;
};

TableText parsed(std::istream& in) {
  TableText table;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) {
      table.provenance += line + "\n";
    } else if (table.header.empty()) {
      table.header = line;
    } else {
      std::vector<std::string> cells;
      std::istringstream parts(line);
      for (std::string cell; std::getline(parts, cell, ',');) cells.push_back(cell);
      table.rows.push_back(cells);
    }
  }
  return table;
}

/// Inputs, component and unit are the same words; the values agree within both errors.
void compare_rows(const std::vector<std::string>& stored, const std::vector<std::string>& made) {
  REQUIRE(stored.size() == made.size());
  const std::size_t value = stored.size() - 3, error = stored.size() - 2;
  for (std::size_t i = 0; i < stored.size(); ++i)
    if (i != value && i != error) CHECK(stored[i] == made[i]);
  const Number stored_error(stored[error]), made_error(made[error]);
  INFO("stored " << stored[value] << " +- " << stored[error] << ", made " << made[value] << " +- "
                 << made[error]);
  CHECK(abs(Number(stored[value]) - Number(made[value])) <= stored_error + made_error);
  CHECK(made_error <= 10 * stored_error);
}

}  // namespace

TEST_CASE("every table made again is the table stored", "[reference][slow]") {
  const std::vector<truth::Entry>& all = truth::registry();
  std::vector<std::string> again(all.size());
  std::for_each(std::execution::par, all.begin(), all.end(), [&](const truth::Entry& entry) {
    std::string& text = again[static_cast<std::size_t>(&entry - all.data())];
    try {
      text = truth::table(std::string(entry.name), entry.make());
    } catch (const std::exception& error) {
      text = error.what();
    }
  });
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string name(all[k].name);
    INFO("make_reference reference " << name << " would make the table again");
    std::istringstream text(again[k]);
    std::ifstream file(tables / (name + ".csv"));
    const TableText made = parsed(text), stored = parsed(file);
    CHECK(stored.provenance == made.provenance);
    CHECK(stored.header == made.header);
    REQUIRE(stored.rows.size() == made.rows.size());
    for (std::size_t i = 0; i < stored.rows.size(); ++i) compare_rows(stored.rows[i], made.rows[i]);
  }
}

TEST_CASE("every table in the folder has a maker", "[reference]") {
  for (const auto& file : fs::directory_iterator(tables)) {
    if (file.path().extension() != ".csv" || file.path().filename() == "verdicts.csv") continue;
    const auto& all = truth::registry();
    INFO(file.path().string());
    CHECK(std::any_of(all.begin(), all.end(),
                      [&](const auto& entry) { return entry.name == file.path().stem(); }));
  }
}
