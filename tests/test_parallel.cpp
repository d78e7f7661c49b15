// Progress of parallel work, as shown to a progress display.

#include "chapters/contents.hpp"
#include "report/study/parallel.hpp"
#include "report/verify/catch.hpp"

using namespace oddity;

namespace {

struct Heard {
  std::string stage;
  double done;
  std::size_t all;
  bool operator==(const Heard&) const = default;
};

}  // namespace

TEST_CASE("a stage reports finished pieces, and those begun", "[parallel]") {
  std::vector<Heard> told;
  const Progress progress = [&](const std::string& stage, double done, std::size_t all) {
    told.push_back({stage, done, all});
  };
  Stage stage(progress, "working", 2);
  stage.beat();
  stage.come_to(0.25);
  stage.come_to(0.5);
  stage.add();
  stage.add();
  CHECK(told == std::vector<Heard>{{"working", 0, 2},
                                   {"working", 0, 2},
                                   {"working", 0.25, 2},
                                   {"working", 0.5, 2},
                                   {"working", 1, 2},
                                   {"working", 2, 2}});
  const Progress nobody;
  Stage(nobody, "working", 1).add();
}

TEST_CASE("a run reports its work, and whether it is timed", "[parallel]") {
  const Entry& entry = *std::ranges::find(registry(), Number{8, 1}, &Entry::number);
  const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  for (bool timed : {false, true}) {
    std::set<std::string> stages;
    std::size_t all = 0;
    double done = 0;
    run(std::vector{Task(entry)}, truth, timed, [&](const std::string& stage, double so_far, std::size_t of) {
      stages.insert(stage);
      done = so_far, all = of;
    });
    CHECK(stages == std::set<std::string>{"studying the exercises",
                                          timed ? "running and timing the trials" : "running the trials"});
    CHECK(all > 0);
    CHECK(done == static_cast<double>(all));
  }
}
