// Results of `oddity bench` that do not depend on the clock.

#include "extras/bench/bench.hpp"

#include <cstdint>
#include <cstdio>
#include <fstream>

#include "extras/bench/fresh_pages.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

TEST_CASE("integrators and loops written by hand do the same arithmetic", "[bench]") {
  const std::vector<Race> all = races();
  REQUIRE(all.size() == 15);
  for (const Race& race : all) {
    INFO(race.model << ", " << race.algorithm);
    const Run hand = race.by_hand();
    CHECK(hand.state.size() == static_cast<std::size_t>(race.states));
    for (const Run& integrated : {race.inlined(), race.precompiled()}) {
      CHECK(hand.evaluations == integrated.evaluations);
      CHECK(distance(hand.state, integrated.state) <= (race.algorithm == "Fehlberg 7(8)" ? 1e-12 : 0));
    }
    CHECK(hand.evaluations > 100);
  }
}

TEST_CASE("the median and half the interquartile range", "[bench]") {
  const Spread spread = spread_of({5, 1, 4, 2, 3, 9, 7, 8});
  CHECK(spread.median == 5);
  CHECK(spread.half_width == 2.5);
  CHECK(spread_of({2}).median == 2);
}

TEST_CASE("a limit holds or is broken by more than the spread, else it is undecided", "[bench]") {
  const auto measured = [](double median, double half_width) {
    return Bound{"a ratio", {median, half_width}, 1.05};
  };
  for (const Bound& l : {measured(1.05, 0), measured(1, 0.05), measured(0.5, 0.1)}) {
    CHECK(l.holds());
    CHECK_FALSE(l.broken());
  }
  for (const Bound& l : {measured(1.06, 0), measured(1.2, 0.1)}) {
    CHECK_FALSE(l.holds());
    CHECK(l.broken());
  }
  for (const Bound& l : {measured(1.06, 0.02), measured(1.04, 0.02), measured(1.2, 0.2)}) {
    CHECK_FALSE(l.holds());
    CHECK_FALSE(l.broken());
  }
}

TEST_CASE("the critical path is the longest study and then the longest trial", "[bench]") {
  const SuiteTime suite{{{"3.1", "a", 1, 9, 3, "x"}, {"3.3", "b", 2, 9, 2, "y"}}, 20, {10, 1}};
  CHECK(suite.critical_path() == 5);
  CHECK(suite.speed_up() == 2);
}

namespace {

/// A run with this one limited ratio; everything else holds.
Bench bench_of(const Spread& ratio) {
  const Entrant entrant{"Fehlberg 7(8), tolerance 1e-09", 1e-9, 1300, 5e-10, 6e-10, {2e-5, 1e-7}, {1760, 20}};
  const Entrant series{"series", 0, 1, 1e-16, 2e-16, {4e-8, 1e-9}, {3.6, 0.1}};
  Bench bench{"perf_event_open: no", {}, {}, {{{"3.5", "Pendulum", 0.1, 0.2, 0.05, "swing"}}, 8, {5, 0.1}}};
  bench.races = {
      {"pendulum", 2, "Runge-Kutta 4", 1.05, {1e-8, 0}, {1.2e-8, 0}, {1.5e-8, 0}, ratio, 10, 11, 0},
      {"pendulum", 2, "explicit Euler", 0, {1e-8, 0}, {1.1e-8, 0}, {1.9e-8, 0}, {1.1, 0.01}, 10, 11, 0}};
  bench.contests = {{"pendulum", "pendulum", 1e-9, 1.1e-8, entrant, entrant, 2000, series, 20}};
  return bench;
}

}  // namespace

TEST_CASE("the view shows each limit and whether it held", "[bench]") {
  const std::string view = bench_view(bench_of({1.2, 0.01}));
  for (const char* part : {"1.05, BROKEN", "2000, holds", "20, holds", "10, holds", "3.6", "1.60", "1760",
                           "perf_event_open: no", "5e-10", "6e-10", "swing", "3.0 to 8.0 ns longer"}) {
    INFO(view);
    CHECK(view.find(part) != std::string::npos);
  }
}

TEST_CASE("the last line reports whether all limits hold", "[bench]") {
  const auto last_line = [](const Bench& bench) {
    const std::string view = bench_view(bench);
    return view.substr(view.rfind('\n', view.size() - 2) + 1);
  };
  const Bench good = bench_of({1.03, 0.01}), unclear = bench_of({1.06, 0.02}), bad = bench_of({1.2, 0.01});
  CHECK(last_line(good) == "4 of 4 limits hold.\n");
  CHECK(last_line(unclear) == "3 of 4 limits hold; not: pendulum by Runge-Kutta 4 (undecided).\n");
  CHECK(last_line(bad) == "3 of 4 limits hold; not: pendulum by Runge-Kutta 4 (BROKEN).\n");
  CHECK_FALSE(good.broken());
  CHECK_FALSE(unclear.broken());
  CHECK(bad.broken());
}

TEST_CASE("code that is moved is on pages of no file, and does the same as before", "[bench]") {
  const auto here = reinterpret_cast<std::uintptr_t>(&move_code_to_fresh_pages);
  const auto lies_on_a_file = [&] {
    std::ifstream all("/proc/self/maps");
    for (std::string line; std::getline(all, line);) {
      std::uintptr_t begin = 0, end = 0;
      unsigned long inode = 0;
      REQUIRE(std::sscanf(line.c_str(), "%lx-%lx %*s %*s %*s %lu", &begin, &end, &inode) == 3);
      if (begin <= here && here < end) return inode != 0;
    }
    FAIL("the function is nowhere");
    return false;
  };
  const double before = spread_of({3, 1, 2}).median;
  for (int round = 0; round < 2; ++round) {
    move_code_to_fresh_pages();
    CHECK_FALSE(lies_on_a_file());
    CHECK(spread_of({3, 1, 2}).median == before);
  }
}
