// A scene with events, used like the book's scenes: trials, the cheapest method, limits, the map. Only the
// model knows of the events.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "chapters/examples/bouncing_ball/scene.hpp"
#include "report/pages/stability_view.hpp"
#include "report/study/choose.hpp"
#include "report/study/limit_records.hpp"
#include "report/study/stability.hpp"
#include "report/verify/catch.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

const Entry entry{{3, 97},
                  "",
                  {"Bouncing ball", "", bouncing_ball::parameters, bouncing_ball::scene(1),
                   [](const Parameters& p, const Reference& truth) {
                     return Findings{{}, {motion(bouncing_ball::scene(1), p, truth)}};
                   }}};

Quantity ball(const Horizon& horizon, double e = 0.5) {
  Parameters p(bouncing_ball::parameters);
  p.set("e", e);
  return motion(bouncing_ball::scene(1), p, horizon, Reference::nothing());
}

/// One nanosecond per evaluation.
Time counted_cost(const Method& m, double setting) {
  return {static_cast<double>(m.run(setting).evaluations) * 1e-9, 0};
}

}  // namespace

TEST_CASE("the closed form of the ball's flights lands where it should", "[events]") {
  const bouncing_ball::Flights<double> flights{{1, 8, 0.5}};  // falls for 0.5 s, lands at 4 m/s
  CHECK(near(flights.at(0.25)[0], 0.75, 1e-15));
  CHECK(near(flights.at(0.5)[0], 0, 1e-15));
  CHECK(near(flights.at(0.75)[0], 0.25, 1e-15));
  CHECK(near(flights.at(1.125)[0], 0.0625, 1e-15));
  CHECK(near(flights.p.rest(), 1.5, 1e-15));
  CHECK(flights.at(1.4999)[0] > 0);
  CHECK(flights.at(1.5)[0] == 0);
  CHECK(flights.at(100)[0] == 0);
}

TEST_CASE("every method of the scene bounces, at every frame", "[events]") {
  const Quantity q = ball({1, 4, 60});
  CHECK(q.methods.size() > 15);
  for (const Method& m : q.methods) {
    INFO(m.model << ", " << m.algorithm);
    const Trial trial = run(q, m, m.resolution.settings.empty() ? 0 : m.resolution.settings.back());
    const bool first_order = m.algorithm.ends_with("Euler");
    CHECK(trial.outcome == (first_order ? Outcome::inaccurate : Outcome::ok));
    CHECK(trial.error < (first_order ? 0.02 : 1e-6));
  }
}

TEST_CASE("endless bounces are an outcome of the scene, and so is its ball that never rests", "[events]") {
  const Quantity beyond = ball({2});  // at rest after 1.355 s
  for (const Method& m : beyond.methods) {
    INFO(m.model << ", " << m.algorithm);
    const Trial trial = run(beyond, m, m.resolution.settings.empty() ? 0 : m.resolution.settings.back());
    if (m.model == "flights" || m.algorithm == "explicit Euler") {
      CHECK(trial.answer.reached());
    } else if (m.model != "ball") {  // it comes to rest
      const bool first_order = m.algorithm == "symplectic Euler";
      CHECK(trial.outcome == (first_order ? Outcome::inaccurate : Outcome::ok));
      if (first_order)
        CHECK(near(run(beyond, m, 2 * m.resolution.settings.back()).error / trial.error, 2, 0.1));
      CHECK(*std::prev(trial.answer.value.end()) == 0);
    } else {
      // GSL's bsimp weighs errors by the state alone, and finds no step when the state is almost zero.
      CHECK(trial.outcome == (m.algorithm == "GSL bsimp" ? Outcome::stalled : Outcome::chattering));
      const bool first_order = m.algorithm.ends_with("Euler");  // each bounce is off by a step
      CHECK(trial.answer.message.find(first_order ? "at t = 1.3" : "at t = 1.35") != std::string::npos);
    }
  }
}

TEST_CASE("the cheapest method is chosen for a scene with events", "[events]") {
  Need need{0.01};
  need.horizon = 1;
  need.frames_per_second = 60;
  const Task task(entry);
  const Choice choice = choose(task, need, Reference::nothing(), counted_cost);
  REQUIRE(choice.chosen);
  CHECK(choice.chosen->model == "flights");
  need.exclude = {"closed"};
  const Choice stepped = choose(task, need, Reference::nothing(), counted_cost);
  REQUIRE(stepped.chosen);
  CHECK(stepped.chosen->algorithm == "velocity Verlet");
  CHECK(stepped.chosen->error < 1e-9);
  const auto euler = std::ranges::find(stepped.candidates, "explicit Euler", &Candidate::algorithm);
  REQUIRE(euler != stepped.candidates.end());
  CHECK(euler->error > stepped.chosen->error * 1e3);
}

TEST_CASE("limits and maps are those of the bouncing ball", "[events]") {
  const Task task(entry);
  const Results results = with_stability(run(std::span(&task, 1), Reference::nothing(), false),
                                         std::span(&task, 1), Reference::nothing());
  REQUIRE(results.exercises.size() == 1);
  CHECK(results.exercises[0].failure == "");
  REQUIRE(results.exercises[0].stability);
  const Stability& s = *results.exercises[0].stability;
  CHECK(s.limits.size() == 13);
  for (const Limit& l : s.limits) {
    INFO(l.algorithm << ", " << shown_step(l));
    CHECK(l.step() > 0);
  }
  REQUIRE_FALSE(s.map.empty());
  for (const MapRow& row : s.map) {
    INFO(row.algorithm << " at " << row.value << ": " << letters(row));
    const bool rests = row.value == 0.25;  // before the horizon
    const bool never = row.algorithm == "explicit Euler" || row.algorithm == "symplectic Euler";
    if (rests && !never && row.model == "ball")
      CHECK(std::ranges::count(row.outcomes, Outcome::chattering) == std::ssize(row.outcomes));
    else if (row.algorithm == "Runge-Kutta 4")
      CHECK(std::ranges::count(row.outcomes, Outcome::ok) == std::ssize(row.outcomes));
  }
}
