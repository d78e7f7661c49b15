#include <sys/stat.h>

#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <fstream>

#include "chapters/contents.hpp"
#include "chapters/scene.hpp"
#include "report/study/engines.hpp"
#include "report/study/starts.hpp"
#include "tests/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/scratch_folder.hpp"

using namespace oddity;

namespace {

Need need_of(double horizon, double frames_per_second) {
  return {.error = degree,
          .horizon = horizon,
          .frames_per_second = frames_per_second,
          .errors = {{"m", centimeter}, {"rad", degree}}};
}

/// An engine that answers a request by this shell command.
EngineProgram engine_that(const std::filesystem::path& folder, const std::string& command) {
  const std::filesystem::path program = folder / "engine_fake";
  std::ofstream(program) << R"(#!/bin/sh
if [ "$1" = --about ]; then
  echo '{"name": "Fake", "version": "1", "precision": "double", "plane": false,
         "variants": [{"name": "defaults", "says": "", "order": 1, "defaults": true}]}'
  exit
fi
)" << command << "\n";
  chmod(program.c_str(), 0755);
  const auto found = engines_found(folder, folder);
  REQUIRE(found.size() == 1);
  return found.front();
}

EngineTrial trial_of(const std::string& command, double limit = 60) {
  const ScratchFolder scratch;
  const EngineProgram engine = engine_that(scratch.path(), command);
  const EngineScene scene = further_engine_scene("free body", need_of(0.1, 60));
  return run(engine, engine.variants.front(), scene, 1, {.limit = limit});
}

}  // namespace

TEST_CASE("what an engine does to its process is an outcome", "[engines]") {
  const EngineTrial aborted = trial_of("kill -ABRT $$");
  CHECK(aborted.outcome == Outcome::raised);
  CHECK(aborted.message.find("signal 6") != std::string::npos);

  const EngineTrial hanging = trial_of("sleep 100", 0.2);
  CHECK(hanging.outcome == Outcome::stalled);

  const EngineTrial failing = trial_of("echo out of luck >&2; exit 3");
  CHECK(failing.outcome == Outcome::raised);
  CHECK(failing.message == "status 3: out of luck\n");

  const EngineTrial babbling = trial_of("echo hello");
  CHECK(babbling.outcome == Outcome::raised);
  CHECK(babbling.message.find("no reply") != std::string::npos);
}

TEST_CASE("an engine that is gone is an outcome", "[engines]") {
  const ScratchFolder scratch;
  const EngineProgram engine = engine_that(scratch.path(), "exit");
  std::filesystem::remove(engine.command.front());
  const EngineScene scene = further_engine_scene("free body", need_of(0.1, 60));
  const EngineTrial trial = run(engine, engine.variants.front(), scene, 1, {});
  CHECK(trial.outcome == Outcome::raised);
  CHECK(trial.message.starts_with("not started"));
}

TEST_CASE("an engine whose numbers end before the motion does is judged so", "[engines]") {
  const EngineTrial trial = trial_of(
      R"(echo '{"frames": [[{"position": [0,0,0], "orientation": [1,0,0,0], "velocity": [0,0,0], "spin": [1.7,0,1]}]],
                "seconds": [0.1], "same_bits": true, "restored": "", "cannot": ""}')");
  CHECK(trial.outcome == Outcome::non_finite);
  CHECK(std::isnan(trial.in_needs));
}

TEST_CASE("an engine that has no such scene says why", "[engines]") {
  const ScratchFolder scratch;
  const EngineProgram engine = engine_that(
      scratch.path(),
      R"(echo '{"frames": [], "seconds": [], "same_bits": true, "restored": "", "cannot": "no spin"}')");
  const EngineContest contest = run({engine}, further_engine_scene("free body", need_of(0.1, 60)), {});
  REQUIRE(contest.series.size() == 1);
  CHECK(contest.series.front().cannot == "no spin");
  CHECK(contest.series.front().trials.empty());
}

TEST_CASE("every scene starts in engines where it starts in the book", "[engines]") {
  const Need soon = need_of(1e-5, 1e5);
  const Reference truth(std::filesystem::path(ODDITY_SOURCE) / "reference");
  std::vector<EngineScene> scenes;
  for (const Entry& entry : registry())
    if (has_engine_scene(entry)) scenes.push_back(engine_scene(Task(entry), soon, truth));
  CHECK(scenes.size() >= 9);
  for (const std::string& name : further_engine_scenes()) scenes.push_back(further_engine_scene(name, soon));
  for (const EngineScene& scene : scenes) {
    INFO(scene.scene);
    std::vector<engines::State> start;
    for (const auto& body : scene.staging.world.bodies) start.push_back(body.start);
    CHECK(distance(Value(scene.staging.observe(start, 0)), scene.motion.reference.value) < 1e-3);
  }
}

TEST_CASE("the free body's closed form is the solution of Euler's equations", "[engines]") {
  const EngineScene scene = further_engine_scene("free body", need_of(10, 10));
  namespace odeint = boost::numeric::odeint;
  using Spin = std::array<double, 3>;
  const auto euler = [](const Spin& w, Spin& dwdt, double) {
    dwdt = {-1.0 * w[1] * w[2], 2.0 / 2 * w[2] * w[0], -1.0 / 3 * w[0] * w[1]};
  };
  Spin w{1.7, 0, 1};
  const double L = std::hypot(1.7, 3.0);
  auto stepper = odeint::make_controlled(1e-13, 1e-13, odeint::runge_kutta_fehlberg78<Spin>());
  for (std::size_t frame = 0; frame < 100; ++frame) {
    odeint::integrate_adaptive(stepper, euler, w, 0.0, 0.1, 0.01);
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(scene.motion.reference.value[3 * frame + i] == Approx(double(i + 1) * w[i] / L).margin(1e-10));
  }
}

TEST_CASE("a scene that is not set up for engines is named with those that are", "[engines]") {
  const auto entry = std::ranges::find_if_not(registry(), has_engine_scene);
  const std::string says = complaint([&] { require_engine_scene(*entry); });
  CHECK(says.find("is not set up for engines; 3.5, ") != std::string::npos);
  CHECK(complaint([] {
          further_engine_scene("fre body", need_of(1, 60));
        }).find("did you mean 'free body'?") != std::string::npos);
}

TEST_CASE("what engines did is read as it was written", "[engines]") {
  EngineSeries series{"Fake", "1", "float", "defaults", "nothing set"};
  for (int steps = 1; steps <= 16; steps *= 2) {
    EngineTrial trial{steps};
    trial.errors = {0.5 / steps};
    trial.in_needs = 5.0 / steps;
    trial.outcome = trial.in_needs <= 1 ? Outcome::ok : Outcome::inaccurate;
    trial.energy = std::nan("");
    series.trials.push_back(trial);
  }
  EngineContest contest{"3.5", "Pendulum", {"rad"},  {0.1},
                        10,    60,         {series}, Instead{"one angle", {0.01}, 1e-8}};
  const ScratchFolder scratch;
  const auto file = scratch.path() / "engines.json";
  write({contest}, file);
  const auto read = read_engines(file);
  REQUIRE(read.size() == 1);
  REQUIRE(read[0].series.size() == 1);
  const EngineSeries& again = read[0].series[0];
  CHECK(again.trials.size() == 5);
  CHECK(std::isnan(again.trials[0].energy));
  REQUIRE(again.law);
  CHECK(again.law->exponent == Approx(1));
  REQUIRE(again.first_enough());
  CHECK(again.first_enough()->steps_per_frame == 8);
  CHECK(read[0].least->says == "one angle");

  std::ofstream(file) << "[{\"scene\": 1}]";
  CHECK(complaint([&] { read_engines(file); }).find("not what 'oddity engines' writes") != std::string::npos);
}
