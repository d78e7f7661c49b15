// Generation of the tables. Every tabulated value can be computed again.

#include "reference/truth.hpp"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include "reference/made_again.hpp"
#include "reference/make/aside.hpp"
#include "reference/make/motions.hpp"
#include "reference/reference.hpp"
#include "reference/text.hpp"
#include "report/study/parallel.hpp"
#include "report/verify/catch.hpp"
#include "tests/near.hpp"

using namespace oddity;
namespace fs = std::filesystem;

namespace {

const fs::path tables = fs::path(ODDITY_SOURCE) / "reference";

truth::Truth two_routes(truth::Route first, truth::Route second) {
  return {"a test", "x", {"x"}, {{"x", "1"}}, {{1}}, "first", std::move(first), "second", std::move(second)};
}

truth::Route gives(const truth::Number& x) {
  return [x](const std::vector<double>&, int) { return truth::Numbers{x}; };
}

}  // namespace

TEST_CASE("a new row's error bounds the disagreement of its routes by a power of ten", "[reference]") {
  const auto error = [](const truth::Number& first, const truth::Number& second) {
    return truth::make_row(two_routes(gives(first), gives(second)), {1}, 30).error;
  };
  CHECK(error(1, 1) == pow(truth::Number(10), -30));
  CHECK(abs(error(1000, 1000) / pow(truth::Number(10), -27) - 1) < 1e-40);
  CHECK(error(1, truth::Number("1.0000003")) == pow(truth::Number(10), -6));
  CHECK(error(0, truth::Number("3e-20")) == pow(truth::Number(10), -19));
}

TEST_CASE("a new row's error is relative to its largest component", "[reference]") {
  const truth::Number small("2e-13");
  const truth::Made made = truth::make_row(two_routes(gives(small), gives(small)), {1}, 24);
  CHECK(made.error < truth::Number("1e-35"));
  CHECK(made.error >= small * truth::Number("1e-24"));
  truth::Truth two = two_routes(
      [](const auto&, int) {
        return truth::Numbers{0, 1000};
      },
      [](const auto&, int) {
        return truth::Numbers{0, 1000};
      });
  two.components.push_back({"y", "1"});
  CHECK(abs(truth::make_row(two, {1}, 24).error / pow(truth::Number(10), -21) - 1) < 1e-30);
  CHECK(truth::make_row(two_routes(gives(0), gives(0)), {1}, 24).error == pow(truth::Number(10), -24));
}

TEST_CASE("a small determinant computed on the spot has as many digits as a large one", "[reference]") {
  const Reference stored(tables);
  std::vector<double> tiny(16, 0.0);
  for (std::size_t i = 0; i < 4; ++i) tiny[5 * i] = 0.001 * static_cast<double>(i + 1);
  const Known known = stored("07_09_determinant", tiny);
  CHECK(near(known.value[0], 2.4e-11, 1e-25));
  CHECK(known.error < 1e-26);
}

TEST_CASE("a route without a finite value gives no row", "[reference]") {
  const truth::Number nan = std::numeric_limits<truth::Number>::quiet_NaN(),
                      inf = std::numeric_limits<truth::Number>::infinity();
  for (const truth::Number& bad : {nan, inf}) {
    CHECK_THROWS_AS(truth::make_row(two_routes(gives(bad), gives(1)), {1}, 24), std::domain_error);
    CHECK_THROWS_AS(truth::make_row(two_routes(gives(1), gives(bad)), {1}, 24), std::domain_error);
  }
  const truth::Route empty = [](const std::vector<double>&, int) { return truth::Numbers{}; };
  CHECK_THROWS_AS(truth::make_row(two_routes(empty, gives(1)), {1}, 24), std::logic_error);
  CHECK_THROWS_AS(truth::make_row(two_routes(gives(1), empty), {1}, 24), std::logic_error);
}

namespace {

constexpr std::chrono::milliseconds moment(1);

/// Sleeps in small pieces, for a minute at most.
truth::Numbers dawdle(const std::vector<double>&, truth::Precision precision) {
  for (int piece = 0; piece < 60'000; ++piece) {
    std::this_thread::sleep_for(moment);
    precision.kept->tick();
  }
  return {1};
}

truth::Numbers break_down(const std::vector<double>&, truth::Precision) {
  throw std::runtime_error("broke down");
}

}  // namespace

TEST_CASE("a motion's error is the disagreement of its routes up to each time compared", "[reference]") {
  const truth::Route first = [](const auto& at, int) { return truth::Numbers{at[0]}; };
  const truth::Route second = [](const auto& at, int) {
    return truth::Numbers{at[0] + ldexp(truth::Number(1), -static_cast<int>(10 * (5 - at[0])))};
  };
  const truth::Made made = truth::make_motion(two_routes(first, second), {}, {1, 2, 3, 4}, 30, 2);
  CHECK(made.value == truth::Numbers{1, 2, 3, 4});
  const auto ten = [](int power) { return pow(truth::Number(10), power); };
  CHECK(made.error_until == truth::Numbers{ten(-9), ten(-9), ten(-3), ten(-3)});
  CHECK(made.error == ten(-3));
}

TEST_CASE("a motion ends by an exception of either route, without waiting for the other", "[reference]") {
  const std::vector<double> times{1, 2};
  const auto watched = [](double) {};
  for (const auto& two : {two_routes(break_down, dawdle), two_routes(dawdle, break_down)})
    CHECK_THROWS_WITH(truth::make_motion(two, {}, times, 24, 2, watched), "broke down");
  int ticks = 0;
  const auto ends = [&](double) {
    if (++ticks > 3) throw std::runtime_error("enough");
  };
  for (const auto& two : {two_routes(gives(1), dawdle), two_routes(dawdle, gives(1))}) {
    ticks = 0;
    CHECK_THROWS_WITH(truth::make_motion(two, {}, times, 24, 2, ends), "enough");
  }
}

TEST_CASE("a background value is computed once, or ends when nobody needs it", "[reference]") {
  const truth::Tick none, watched = [](double) {};
  for (const truth::Tick& tick : {none, watched}) {
    truth::Aside<bool> is_watched(tick, [](const truth::Tick& own) { return static_cast<bool>(own); });
    CHECK(is_watched.get() == static_cast<bool>(tick));
  }
  std::atomic<bool> was_ended = false;
  {
    const truth::Aside<int> unwanted(watched, [&](const truth::Tick& own) {
      try {
        while (true) std::this_thread::sleep_for(moment), own(0);
      } catch (...) {
        was_ended = true;
        throw;
      }
      return 0;
    });
    CHECK_FALSE(unwanted.is_ready());
  }
  CHECK(was_ended);
}

TEST_CASE("a table's text consists of its provenance, its header and its rows", "[reference]") {
  CHECK(truth::table("00_00_test", two_routes(gives(truth::Number(1) / 3), gives(truth::Number(1) / 3))) ==
        "# a test\n"
        "# formula: x\n"
        "# made by: reference/make/00_00_test.cpp, working with 60 digits (MPFR)\n"
        "# first route: first\n"
        "# second route: second\n"
        "# error: bounds the disagreement of the two routes, rounded up to a power of ten\n"
        "# inputs: the double nearest to the decimal shown, taken as exact\n"
        "x,component,value,error,bound,unit\n"
        "1,x,0.3333333333333333333333333333333333333333,1e-42,agreement,1\n");
}

TEST_CASE("a table's errors are distances from an enclosure, if there is one", "[reference]") {
  truth::Truth third = two_routes(gives(truth::Number(1) / 3), gives(truth::Number(1) / 3));
  third.enclosure = "a third";
  third.enclosed = third.first;
  const std::string text = truth::table(
      "00_00_test", third, [](const std::vector<double>&, const std::vector<std::string>& decimals) {
        CHECK(decimals == std::vector<std::string>{"0.3333333333333333333333333333333333333333"});
        return std::optional(std::vector{3.4e-41});
      });
  CHECK(
      text.find(
          "# enclosure: a third, in balls (Arb)\n"
          "# error: bounds the distance from all numbers in the enclosure, rounded up to a power of ten\n") !=
      std::string::npos);
  CHECK(text.ends_with("\n1,x,0.3333333333333333333333333333333333333333,1e-40,enclosure,1\n"));
}

TEST_CASE("a row made on the spot agrees with the table's", "[reference]") {
  const Reference stored(tables);
  for (const truth::Entry& entry : truth::registry()) {
    const std::string name(entry.name);
    if (name != "03_05_quarter_period" && name != "03_05_swing") continue;
    const truth::Truth generator = entry.make();
    for (const auto& inputs : generator.rows) {
      const truth::Made made = truth::make_row(generator, inputs, truth::spot_digits);
      const Known known = stored(name, inputs);
      CHECK(near(static_cast<double>(made.value[0]), known.value[0], known.error));
      CHECK(made.error < 1e-22);
    }
  }
}

namespace {

/// Every row of every table, with the rows in parallel.
std::vector<truth::MadeAgain> all_made_again() {
  std::vector<truth::MadeAgain> all(truth::registry().begin(), truth::registry().end());
  std::vector<std::pair<truth::MadeAgain*, std::size_t>> work;
  for (truth::MadeAgain& table : all)
    for (std::size_t row = 0; row < table.rows(); ++row) work.emplace_back(&table, row);
  parallel_for_each(work, [](const auto& piece) { piece.first->make(piece.second); });
  return all;
}

}  // namespace

TEST_CASE("every tabulated value computed again equals the stored value", "[reference][slow]") {
  const std::vector<truth::Entry>& all = truth::registry();
  const std::vector<truth::MadeAgain> again = all_made_again();
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string name(all[k].name);
    INFO("make_reference reference " << name << " would make the table again");
    std::ifstream file(tables / "tables" / (name + ".csv"));
    CHECK(again[k].differences(file) == std::vector<std::string>());
  }
}

TEST_CASE("a table with another value, error, unit or row differs from its recomputation", "[reference]") {
  const truth::Entry entry{"a_test", [] { return two_routes(gives(2), gives(2)); }};
  truth::MadeAgain again(entry);
  again.make(0);
  const std::string heading = truth::heading("a_test", two_routes({}, {}));
  const auto differences = [&](const std::string& rows) {
    std::istringstream stored(heading + rows);
    return again.differences(stored).size();
  };
  CHECK(differences("1,x,2,1e-40,agreement,1\n") == 0);
  CHECK(differences("1,x,2.0000000000000001,1e-40,agreement,1\n") == 1);
  CHECK(differences("1,x,2,0,agreement,1\n") == 1);
  CHECK(differences("1,x,2,1e-3,agreement,1\n") == 1);
  CHECK(differences("2,y,2,1e-40,agreement,m\n") == 3);
  CHECK(differences("1,x,2,1e-40,agreement,1\n1,x,2,1e-40,agreement,1\n") == 1);
  CHECK(differences("1,x,2\n") == 1);
}

TEST_CASE("a recomputed table needs two routes that agree", "[reference]") {
  const auto differences = [](const truth::Number& second, const std::string& error) {
    static truth::Number other;
    other = second;
    truth::MadeAgain again({"a_test", [] { return two_routes(gives(2), gives(other)); }});
    again.make(0);
    std::istringstream stored(truth::heading("a_test", two_routes({}, {})) + "1,x,2," + error +
                              ",agreement,1\n");
    return again.differences(stored).size();
  };
  const truth::Number two("2.00000000000001");
  CHECK(differences(2, "1e-40") == 0);
  CHECK(differences(two, "1e-40") == 1);
  CHECK(differences(two, "1e-20") == 0);  // it has few digits at 42 as well
  CHECK(differences(3, "1e-6") == 1);
}

TEST_CASE("every table in the folder has a generator", "[reference]") {
  for (const auto& file : fs::directory_iterator(tables / "tables")) {
    const auto& all = truth::registry();
    INFO(file.path().string());
    CHECK(std::any_of(all.begin(), all.end(),
                      [&](const auto& entry) { return entry.name == file.path().stem(); }));
  }
}
