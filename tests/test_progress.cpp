// Progress of a long run: nothing impossible is shown.

#include <thread>

#include "report/study/parallel.hpp"
#include "report/study/progress.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

TEST_CASE("the remaining time is shown while work advances evenly", "[progress]") {
  Pace pace;
  for (int i = 1; i <= 10; ++i) pace.come_to(i, i);
  CHECK(pace.line(40, 10) == "10 of 40, about 30 s left");
  CHECK(pace.line(40, 11) == "10 of 40, about 33 s left");
  CHECK(pace.line(40, 30) == "10 of 40, 30 s so far");
  CHECK(pace.line(10, 10) == "10 of 10, 10 s so far");
}

TEST_CASE("the remaining time never grows while one piece takes long", "[progress]") {
  Pace pace;
  pace.come_to(1, 0.01);
  for (double now : {3, 10, 20, 40, 60, 80})
    CHECK(pace.line(3, now) == "1 of 3, " + std::to_string(static_cast<int>(now)) + " s so far");
  pace.come_to(2, 90);
  CHECK(pace.line(3, 100) == "2 of 3, 100 s so far");
}

TEST_CASE("a step back is not shown", "[progress]") {
  Pace pace;
  pace.come_to(2, 1);
  pace.come_to(1, 2);
  CHECK(pace.line(3, 3) == "2 of 3, 3 s so far");
}

TEST_CASE("the progress of a stage never exceeds its total, whatever threads begin", "[progress]") {
  double most = 0;
  const Progress progress = [&](const std::string&, double done, std::size_t) {
    most = std::max(most, done);
  };
  Stage stage(progress, "making", 3);
  for (int i = 0; i < 3; ++i) stage.add();
  for (int i = 0; i < 2; ++i) std::jthread([&] { stage.come_to(1); });
  CHECK(most == 3);
}

TEST_CASE("a piece that is computed in several parts does not step back", "[progress]") {
  double last = 0;
  const Progress progress = [&](const std::string&, double done, std::size_t) { last = done; };
  Stage stage(progress, "making", 2);
  stage.come_to(0.75);
  stage.come_to(0.25);
  CHECK(last == 0.75);
}
