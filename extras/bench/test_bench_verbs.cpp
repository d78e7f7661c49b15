// Cost of the commands, and how their work grows.

#include <csignal>

#include "extras/bench/verbs.hpp"
#include "report/study/run_program.hpp"
#include "report/verify/catch.hpp"
#include "tests/near.hpp"

using namespace oddity;

TEST_CASE("work that doubles with its amount grows with exponent one", "[bench]") {
  CHECK(near_ulps(Growth{"by trials", {1, 2, 4}, {3, 6, 12}}.slope(), 1, 64));
  CHECK(near_ulps(Growth{"by cells", {1, 10, 100}, {2, 200, 20000}}.slope(), 2, 64));
}

TEST_CASE("a program reads its input, and its whole output is returned", "[bench]") {
  const Ended said = run_program({"cat"}, "two\nlines", std::chrono::minutes(1));
  CHECK(said.ok);
  CHECK(said.output == "two\nlines");
  CHECK(said.words.empty());
}

TEST_CASE("a failed program is reported as failed, also where SIGCHLD is ignored", "[bench]") {
  const auto usual = std::signal(SIGCHLD, SIG_IGN);
  CHECK_FALSE(run_program({"false"}, "", std::chrono::minutes(1)).ok);
  std::signal(SIGCHLD, usual);
}

TEST_CASE("a command's row has its time, memory and failure; a growth has a row per point", "[bench]") {
  const VerbsBench bench{{{"list", 0.01, 0.02, 22e6, ""}, {"site", 1, 2, 82e6, "status 2"}},
                         {{"verify, by trials", {10, 20}, {1, 2}}}};
  const Table table = verbs_table(bench);
  REQUIRE(table.rows.size() == 4);
  CHECK(std::get<double>(table.rows[0][5]) == 22e6);
  CHECK(std::get<std::string>(table.rows[1][6]) == "status 2");
  const std::string view = verbs_view(bench);
  CHECK(view.find("82 MB") != std::string::npos);
  CHECK(view.find("status 2") != std::string::npos);
  CHECK(view.find("to the power 1\n") != std::string::npos);
}

TEST_CASE("time and memory of a program that ran are measured", "[bench]") {
  const Ended ended = run_program({ODDITY_PROGRAM, "list"}, "", std::chrono::minutes(1));
  REQUIRE(ended.ok);
  CHECK(ended.cpu_seconds > 0);
  CHECK(ended.peak_bytes > 1e6);
  CHECK(ended.peak_bytes < 1e9);
}
