// The reference tables: their values, and the messages for broken ones.

#include "reference/reference.hpp"

#include "reference/verdicts.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/near.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;
namespace fs = std::filesystem;

namespace {

const fs::path tables = fs::path(ODDITY_SOURCE) / "reference";
constexpr double pi = 3.14159265358979323846;
constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

const Reference& truth() {
  static const Reference all(tables);
  return all;
}

/// The message of reading the tables when one of them has this text instead.
std::string complaint_of(const std::string& table, const std::string& text) {
  const ScratchFolder folder;
  fs::copy(tables, folder.path(), fs::copy_options::recursive);
  const fs::path file = folder.file("tables/" + table + ".csv", text);
  const std::string all = complaint([&] { Reference read(folder.path()); });
  const std::size_t at = all.find(file.string());
  return at == std::string::npos
             ? all
             : all.substr(0, at) + all.substr(at + (folder.path() / "tables").string().size() + 1);
}

constexpr const char* quarter = "03_05_quarter_period";
const std::string header = "# a comment\n\na,component,value,error,bound,unit\n";

}  // namespace

// ---- reading ----------------------------------------------------------------------------------------------

TEST_CASE("a table is read around its comments and empty lines", "[reference]") {
  const ScratchFolder folder;
  fs::copy(tables, folder.path(), fs::copy_options::recursive);
  folder.file("tables/" + std::string(quarter) + ".csv",
              header + "0.5,I,2.25,1e-20,enclosure,1\n# in between\n\n0.75,I,+2.5,1e-20,agreement,1\n");
  const Reference read(folder.path());
  CHECK(read(quarter, {0.5}).value == std::vector{2.25});
  CHECK(read(quarter, {0.75}).value == std::vector{2.5});
  CHECK(read(quarter, {0.75}).error == 2.5 * 0x1p-53);
  CHECK(read(quarter, {0.75}).source == "table 03_05_quarter_period.csv");
}

TEST_CASE("a folder without tables is refused with the folders needed, and a missing table with its file",
          "[reference]") {
  const ScratchFolder folder;
  const auto reading = [&] { Reference read(folder.path()); };
  CHECK(complaint(reading).find("a folder with tables/ and approved/ is needed") != std::string::npos);
  fs::create_directory(folder.path() / "tables");
  const std::string said = complaint(reading);
  CHECK(said.find((folder.path() / "").string()) != std::string::npos);
  CHECK(said.find(".csv: it is not there; build/release/make_reference ") != std::string::npos);
}

TEST_CASE("a broken line is reported with file, line and a suggestion", "[reference]") {
  const auto said = [](const std::string& text) { return complaint_of(quarter, text); };
  const std::string file = "03_05_quarter_period.csv";
  CHECK(said("a,value\n1,2\n") == file + ":1: the columns must be a,component,value,error,bound,unit");
  CHECK(said("b,component,value,error,bound,unit\n1,I,2,1e-9,agreement,1\n") ==
        file + ":1: the columns must be a,component,value,error,bound,unit");
  CHECK(said(header + "0.5,I,2.25,1e-20\n") == file + ":4: 4 cells where the header has 6");
  CHECK(said(header + "0.5,I,2.25,1e-9,agreement,1\n\n0.5,I,2.25,1e-9,agreement,1,1\n") ==
        file + ":6: 7 cells where the header has 6");
  CHECK(said(header + "half,I,2.25,1e-9,agreement,1\n") == file + ":4: 'half' in column 1 is not a number");
  CHECK(said(header + "0.5,I,2.25 ,1e-9,agreement,1\n") == file + ":4: '2.25 ' in column 3 is not a number");
  CHECK(said(header + "0.5,I,,1e-9,agreement,1\n") == file + ":4: '' in column 3 is not a number");
  CHECK(said(header + "0.5,J,2.25,1e-9,agreement,1\n") == file + ":4: component J where I must be");
  CHECK(said(header + "0.5,I,2.25,1e-9,agreement,1\n0.5,I,2.25,1e-9,agreement,1\n") ==
        file + ":5: a second row for these inputs");
  CHECK(said(header + "0.5,I,2.25,1e-9,guess,1\n") ==
        file + ":4: the error is bounded by an enclosure or by agreement, not by guess");
  const std::string quote = file + ":4: not a line of CSV: ";
  CHECK(said(header + "0.5,\"I,2.25,1e-9,agreement,1\n") == quote + "a quotation mark is not closed");
  CHECK(said(header + "0.5,I\\x,2.25,1e-9,agreement,1\n").find(quote) == 0);
}

TEST_CASE("an invalid number or a negative error is reported with file and line", "[reference]") {
  const std::string complaint =
      "03_05_quarter_period.csv:4: inputs and value must be finite, error finite and positive";
  for (const char* row : {"0.5,I,2,0,agreement,1", "0.5,I,nan,1e-9,agreement,1", "0.5,I,inf,1e-9,agreement,1",
                          "nan,I,2,1e-9,agreement,1", "inf,I,2,1e-9,agreement,1", "0.5,I,2,-1e-9,agreement,1",
                          "0.5,I,2,nan,agreement,1", "0.5,I,2,inf,agreement,1"})
    CHECK(complaint_of(quarter, header + row + "\n") == complaint);
}

TEST_CASE("a table without rows is refused", "[reference]") {
  for (const std::string& text : {header, std::string("# a comment\n"), std::string()})
    CHECK(complaint_of(quarter, text) == "03_05_quarter_period.csv: the table has no rows");
}

TEST_CASE("a row with a missing component is reported with its name", "[reference]") {
  std::ifstream in(tables / "tables/03_03_orbit.csv");
  std::string text, line;
  for (int rows = 0; std::getline(in, line); text += line + "\n")
    if (!line.empty() && line[0] != '#' && ++rows == 5) break;  // header, x, y, x, and no y
  CHECK(complaint_of("03_03_orbit", text)
            .find("03_03_orbit.csv: no row for component y at 39.47841760435743,1,1") == 0);
}

TEST_CASE("the repository's tables and verdicts are read", "[reference]") {
  CHECK_NOTHROW(truth());
  CHECK_NOTHROW(read_verdicts(tables / "approved"));
}

// ---- looking up -------------------------------------------------------------------------------------------

TEST_CASE("a tabulated value is the nearest double", "[reference]") {
  const Known half = truth()(quarter, {pi / 2});
  CHECK(half.value ==
        std::vector{2.622057554292119773782374504926});  // sqrt(2) K(1/sqrt 2), the lemniscate's constant
  CHECK(within(half.error, 0, 4e-16));
  CHECK(half.source == "table 03_05_quarter_period.csv");
}

TEST_CASE("a value without a table row is computed on the spot, as its source states", "[reference]") {
  const Known made = truth()(quarter, {0.75});
  CHECK(near_ulps(made.value.at(0), std::sqrt(2) * std::comp_ellint_1(std::sin(0.375)), 4));
  CHECK(within(made.error, 1e-17, 1e-15));
  CHECK(made.source.find("computed on the spot: sqrt(2) K(k)") == 0);
  CHECK(made.source.find("; and double-exponential quadrature") != std::string::npos);
}

TEST_CASE("a value computed on the spot has a proved error, if there is one", "[reference]") {
  const auto proved = [](double distance) {
    return truth().enclosed_by([=](const ToEnclose& asked, const auto&) {
      CHECK(asked.table == quarter);
      return Enclosed{distance, "proved so"};
    });
  };
  const Known near = proved(0.25)(quarter, {0.75});
  CHECK(near.error == 0.25);
  CHECK(near.source.ends_with("; proved so"));
  CHECK(proved(INFINITY)(quarter, {0.75}).error < 1e-15);
  CHECK(proved(0.25)(quarter, {pi / 2}).error < 1e-15);  // from the table
}

TEST_CASE("a table with too few or too many inputs is refused with their number", "[reference]") {
  const auto said = [](const std::vector<double>& inputs) {
    return complaint([&] { truth()("03_05_swing", inputs); });
  };
  CHECK(said({1, 1, 9.81}) == "table 03_05_swing takes 4 inputs (a,L,g,t), not 3");
  CHECK(said({}) == "table 03_05_swing takes 4 inputs (a,L,g,t), not 0");
  CHECK(said({1, 1, 9.81, 1, 1}) == "table 03_05_swing takes 4 inputs (a,L,g,t), not 5");
}

TEST_CASE("a reference that knows nothing answers NaN, as many as the table has components", "[reference]") {
  const Known known = Reference::nothing()("03_27_two_bodies", std::vector<double>(6, 0));
  REQUIRE(known.value.size() == 2);
  for (double x : known.value) CHECK(std::isnan(x));
  CHECK(std::isnan(Reference::nothing()("no_such_table", {}).value[0]));
}

TEST_CASE("an unknown table is named", "[reference]") {
  const Known nothing = truth()("03_05_nothing", {1});
  CHECK(std::isnan(nothing.value[0]));
  CHECK(std::isnan(nothing.error));
  CHECK(
      nothing.source ==
      "no generator of the table 03_05_nothing: write reference/make/03_05_nothing.cpp in the folder that has "
      "the exercise's chapters");
}

TEST_CASE("inputs that are not finite have no reference value", "[reference]") {
  for (double bad : {no_number, infinity, -infinity})
    CHECK(complaint([&] { truth()(quarter, {bad}); }).find("inputs must be finite") != std::string::npos);
}
