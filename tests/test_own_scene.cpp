// Messages for a scene's author: they name the scene and its place.

#include <algorithm>
#include <cmath>

#include "chapters/expect_failure.hpp"
#include "chapters/scene.hpp"
#include "reference/limits.hpp"
#include "reference/quantity_text.hpp"
#include "report/study/approve.hpp"
#include "report/study/limit_records.hpp"
#include "report/study/stability.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"

using namespace oddity;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// A ball falls from 1 m; its floor is at `floor`.
struct Ball {
  double floor;
  using State = std::array<double, 2>;
  State start() const { return {1, 0}; }
  void operator()(const auto& x, auto& dxdt, const auto&) const { dxdt = {x[1], -9.81}; }
  std::array<double, 1> observe(const State& x, double) const { return {x[0]}; }
  std::array<double, 1> guards(const State& x, double) const { return {x[0] - floor}; }
  Happening<State> at_event(std::size_t, const State& x, double) const { return {{floor, -x[1]}}; }
};

/// A right-hand side that is broken from one second on.
struct Broken : Ball {
  using Ball::State;
  void operator()(const State& x, State& dxdt, double t) const {
    if (t > 1) throw std::runtime_error("the table is broken");
    Ball::operator()(x, dxdt, t);
  }
};

constexpr Parameter parameters[] = {{"floor", -1000, "m", "", -1e6, 1}};

template <class Model>
Quantity height(const Parameters& p, const Horizon& horizon, const Reference&) {
  std::vector<double> here(static_cast<std::size_t>(horizon.count()), 1.0);
  Quantity y = quantity("height", "m", "", {here, 1e-9, "a test"}, {1e-3, "a millimetre"});
  Model model;
  static_cast<Ball&>(model).floor = p["floor"];
  SceneMethods(y, horizon, halving("step", 0.125, 2), tolerances()).by<ode::RungeKutta4>("ball", model);
  return y;
}

template <class Model>
Entry entry() {
  Scene scene;
  scene.motion = height<Model>;
  scene.horizon = 8;
  scene.game_tolerance = centimeter;
  scene.sweep_parameter = "floor";
  scene.axes = {{"y"}, "s", {{"m", {0}}}};
  return {{20, 1}, "", {"Ball", "", parameters, scene, [](const Parameters& p, const Reference& truth) {
                          return Findings{{}, {height<Model>(p, {8}, truth)}};
                        }}};
}

Trial trial(double floor) {
  Parameters p(parameters);
  p.set("floor", floor);
  const Quantity y = height<Ball>(p, {8}, Reference::nothing());
  return run(y, y.methods[0], 0.125);
}

}  // namespace

TEST_CASE("a motion that is wrong for lack of an event is reported as such", "[own]") {
  const Trial away = trial(-1000);
  CHECK(away.outcome == Outcome::diverged);
  CHECK(away.answer.message.starts_with("no event has happened"));
  CHECK(trial(0).answer.message.empty());
}

TEST_CASE("without a reference a finite value is not called wrong", "[own]") {
  Quantity y = height<Ball>(Parameters(parameters), {8}, Reference::nothing());
  y.reference.value = no_number;
  const Trial judged = run(y, y.methods[0], 0.125);
  CHECK(judged.outcome == Outcome::inaccurate);
  CHECK(judged.answer.message == "nothing is known to judge it by");
}

TEST_CASE("one method of a group may be expected to fail", "[own]") {
  Quantity y = height<Ball>(Parameters(parameters), {8}, Reference::nothing());
  expect_failure(y, "ball", "Runge-Kutta 4", Outcome::diverged, "it falls for ever");
  CHECK(y.methods[0].expected == Outcome::diverged);
  CHECK(y.methods[0].why == "it falls for ever");
  CHECK_THROWS_AS(expect_failure(y, "ball", "Heun", Outcome::ok, ""), std::logic_error);
}

TEST_CASE("a missing parameter is reported with its exercise and file", "[own]") {
  const Entry& pendulum = *std::ranges::find(registry(), Number{3, 5}, &Entry::number);
  CHECK(complaint([&] { static_cast<void>(Parameters(pendulum.exercise.parameters)["yo"]); }) ==
        "exercise 3.5 (chapters/03_rigid_body_motion/05_pendulum/exercise.cpp): no parameter 'yo'; the "
        "parameters are: a, L, g");
  CHECK(complaint([&] { static_cast<void>(Parameters{parameters}["yo"]); }) ==
        "no parameter 'yo'; the parameters are: floor");
}

TEST_CASE("a parameter's invalid unit is named when a unit is given", "[own]") {
  CHECK(in_unit("9.81", "m/sec^2") == 9.81);
  CHECK(
      complaint([] { in_unit("9.81m/s^2", "m/sec^2"); }) ==
      "'9.81m/s^2' is for a parameter whose own unit, 'm/sec^2', is unknown: give the number alone, and declare "
      "a unit such as 'm/s^2'");
  for (const Entry& e : registry())
    for (const Parameter& p : e.exercise.parameters) CHECK(is_unit(p.unit));
}

TEST_CASE("a model that throws is a failure of its exercise, by name", "[own]") {
  const Entry broken = entry<Broken>();
  const std::vector<Task> tasks{Task(broken)};
  Results blank;
  blank.exercises.emplace_back();
  const Results results = with_stability(blank, tasks, Reference::nothing());
  CHECK(results.exercises[0].failure == "ball, Runge-Kutta 4: the table is broken");
  blank.exercises[0].failure = "it raised before";
  CHECK(with_stability(blank, tasks, Reference::nothing()).exercises[0].failure == "it raised before");
}

TEST_CASE("a limit is compared with its record, and a difference is named with its number", "[own]") {
  Limit limit;
  limit.stable = 0.1;
  limit.unstable = 0.102;
  limit.tongues = {{0.1, 0.2}};
  limit.at = TimedTrial();
  limit.at->error = no_number;
  ApprovedLimit record;
  record.step = record.theory = 0.1;
  record.unstable = shown_tongues(limit);
  record.watched = 0;
  record.error = no_number;
  record.beyond = beyond(limit);
  CHECK(difference(limit, record) == "");
  record.error = 0.5;
  CHECK(difference(limit, record) == "error 0.5");
  record.error.reset();
  record.step = 0.2;
  CHECK(difference(limit, record) == "step 0.2, error none");
  limit.at->error = 1;
  record.step = 0.1;
  record.error = no_number;
  CHECK(difference(limit, record) == "error nan");
}
