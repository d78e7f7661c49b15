// Kicks from outside, compared with loops by hand.

#include "report/study/kicks.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "problem/scene.hpp"
#include "reference/bad_input.hpp"
#include "report/cli/asked.hpp"
#include "report/study/choose.hpp"
#include "report/study/frames.hpp"
#include "report/study/initial_conditions.hpp"
#include "report/study/run.hpp"
#include "report/verify/catch.hpp"
#include "tests/complaint.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

using State = std::array<double, 2>;

State rates(const State& x) { return {x[1], -9.81 * std::sin(x[0])}; }
State moved(const State& x, double h, const State& d) { return {x[0] + h * d[0], x[1] + h * d[1]}; }

/// The pendulum of a metre after so many steps of Runge-Kutta 4.
State swung(State x, int steps, double h) {
  for (int i = 0; i < steps; ++i) {
    const State a = rates(x), b = rates(moved(x, h / 2, a)), c = rates(moved(x, h / 2, b)),
                d = rates(moved(x, h, c));
    for (std::size_t k = 0; k < 2; ++k) x[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
  }
  return x;
}

/// The angle at each sixtieth of a second up to 2 s; `kick` changes the state at 1 s.
template <class Kicked>
std::vector<double> by_hand(const Kicked& kick) {
  constexpr int steps = 200;
  State x{std::numbers::pi / 6, 0};
  std::vector<double> seen;
  for (int frame = 1; frame <= 120; ++frame) {
    x = swung(x, steps, 1.0 / 60 / steps);
    seen.push_back(x[0]);
    if (frame == 60) kick(x);
  }
  return seen;
}

Need with_kick(const Task& task, const std::string& kick, const std::string& jitter = {}) {
  AskedNeed asked;
  asked.as_engines = true;
  asked.horizon = "2";
  asked.kick = kick;
  asked.jitter = jitter;
  return need_of(task, asked);
}

double off(const Value& seen, const std::vector<double>& expected) {
  REQUIRE(seen.size() == expected.size());
  double most = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) most = std::max(most, std::abs(seen[i] - expected[i]));
  return most;
}

}  // namespace

TEST_CASE("a kick changes the observables, whatever the state of a model consists of", "[kicks]") {
  const Task task = task_of("3.5", {});
  const Scene& scene = *task.entry->exercise.scene;
  struct Jolt {
    std::string kick;
    std::vector<double> expected;
  };
  for (const Jolt& jolt :
       {Jolt{"t=1s,theta'=+2", by_hand([](State& x) { x[1] += 2; })},
        Jolt{"t=1s,theta'=60deg/s", by_hand([](State& x) { x[1] = std::numbers::pi / 3; })},
        Jolt{"t=1s,speed=*-0.5", by_hand([](State& x) { x[1] *= -0.5; })},
        Jolt{"t=1s,theta=0.1", by_hand([](State& x) { x[0] = 0.1; })},
        Jolt{"t=1s,theta=0.1,theta'=-1", by_hand([](State& x) {
               x = {0.1, x[1] - 1};
             })}}) {
    INFO(jolt.kick);
    const Need need = with_kick(task, jolt.kick);
    const Quantity swing =
        motion_at_frames(scene, task.parameters, horizon_of(need), Reference::nothing(), need.kicks);
    for (const char* model : {"one angle", "Cartesian with constraint"}) {
      INFO(model);
      const Method* method = method_of(swing, model, "Fehlberg 7(8)");
      REQUIRE(method);
      CHECK(off(method->run(1e-13).value, jolt.expected) < 1e-11);
    }
    const Answer closed = method_of(swing, "small angle", "closed form")->run(0);
    CHECK(closed.ending == Ending::raised);
    CHECK(closed.message == "it knows no kick");
    const Quantity known = known_motion(scene, task.parameters, horizon_of(need), need,
                                        Reference(std::string(ODDITY_SOURCE) + "/reference"));
    CHECK(off(known.reference.value, jolt.expected) < 1e-12);
    CHECK(known.reference_error < 1e-10);
    CHECK(known.reference_error > 0);
  }
}

TEST_CASE("steps of one length begin again at a kick, which may come between frames", "[kicks]") {
  const Task task = task_of("3.5", {});
  const Need need = with_kick(task, "t=1005ms,theta'=+2", "20%");
  const Quantity swing = motion_at_frames(*task.entry->exercise.scene, task.parameters, horizon_of(need),
                                          Reference::nothing(), need.kicks);
  const auto end = [&](const std::string& algorithm) {
    const Answer answer = method_of(swing, "one angle", algorithm)->run(0.001);
    REQUIRE(answer.reached());
    REQUIRE(answer.value.size() == need.frame_times->at.size());
    return *(answer.value.end() - 1);
  };
  const double divided = end("Runge-Kutta 4");
  for (const char* stepping :
       {", last of fixed steps", ", fixed steps interpolated", ", fixed steps extrapolated"})
    CHECK(near(end(std::string("Runge-Kutta 4") + stepping), divided, 0.02));
}

TEST_CASE("an accumulator comes to a kick by one shorter step", "[kicks]") {
  const Task task = task_of("3.5", {});
  const Need need = with_kick(task, "t=1005ms,theta'=+2", "20%");
  const Quantity swing = motion_at_frames(*task.entry->exercise.scene, task.parameters, horizon_of(need),
                                          Reference::nothing(), need.kicks);
  constexpr double step = 0.02, kick = 1.005;
  const State before = swung(swung({std::numbers::pi / 6, 0}, 50, step), 1, kick - 50 * step);
  const Value drawn = method_of(swing, "one angle", "Runge-Kutta 4, last of fixed steps")->run(step).value;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const double t = need.frame_times->at[i];
    const State expected = t < kick
                               ? swung({std::numbers::pi / 6, 0}, static_cast<int>(t / step), step)
                               : swung({before[0], before[1] + 2}, static_cast<int>((t - kick) / step), step);
    INFO("at " << t);
    CHECK(near(drawn[i], expected[0], 1e-11));
  }
}

TEST_CASE("a kick acts through a model's constraints on all of its coordinates", "[kicks]") {
  const Task task = task_of("3.19", {});
  for (const char* kick : {"t=1s,y2'=+1", "t=1s,y3=+0.1", "t=1s,speed=*0.5"}) {
    INFO(kick);
    const Need need = with_kick(task, kick);
    const Quantity pulleys = motion_at_frames(*task.entry->exercise.scene, task.parameters, horizon_of(need),
                                              Reference::nothing(), need.kicks);
    const Answer two = method_of(pulleys, "two coordinates", "Fehlberg 7(8)")->run(1e-13),
                 four = method_of(pulleys, "four coordinates with tensions", "Fehlberg 7(8)")->run(1e-13);
    INFO(four.message);
    REQUIRE(four.reached());
    CHECK(distance(two.value, four.value) < 1e-9);
  }
}

TEST_CASE("a kick is refused where it does not determine the whole state", "[kicks]") {
  const Entry& entry = problem::entry_of_text("oscillators.toml", R"toml(title = "Two oscillators"
[parameters]
a = { value = "1 1/s^2, 0.1 to 10", says = "one stiffness" }
b = { value = "4 1/s^2, 0.1 to 10", says = "the other" }
[model."two places"]
equations = ["x'' = -a x", "y'' = -b y"]
start = { x = "1 m", "x'" = 0, y = "0 m", "y'" = 0 }
observe = { s = "x + y" }
[model."sum and one place"]
equations = ["s'' = -a s - (b - a) y", "y'' = -b y"]
start = { s = "1 m", "s'" = 0, y = "0 m", "y'" = 0 }
[observe]
s = "m"
)toml");
  const Task task(entry);
  const Need need = with_kick(task, "t=1s,s'=+2");
  const auto complaint_of = [](const Task& of, const Need& asked) {
    return complaint([&] {
      known_motion(*of.entry->exercise.scene, of.parameters, horizon_of(asked), asked,
                   Reference(std::string(ODDITY_SOURCE) + "/reference"));
    });
  };
  const std::string why =
      "the observables do not determine the kick's effect on the rest of the model's state";
  CHECK(complaint_of(task, need).find(why) != std::string::npos);
  for (const char* exercise : {"3.29", "3.33"}) {
    const Task book = task_of(exercise, {});
    INFO(exercise);
    CHECK(complaint_of(book, with_kick(book, "t=1s,speed=*0.5")).find(why) != std::string::npos);
  }
}

TEST_CASE("work that a model adds up does not keep it from a kick", "[kicks]") {
  const Task task = task_of("3.15", {});
  AskedNeed asked;
  asked.as_engines = true;
  asked.horizon = "0.3";
  asked.kick = "t=0.1,speed=*1";
  const Need need = need_of(task, asked);
  const Quantity rod = motion_at_frames(*task.entry->exercise.scene, task.parameters, horizon_of(need),
                                        Reference::nothing(), need.kicks);
  for (const Method& method : rod.methods)
    if (method.algorithm == "Fehlberg 7(8)") {
      INFO(method.model << ": " << method.run(1e-10).message);
      CHECK(method.run(1e-10).reached());
    }
}

TEST_CASE("the ways of a kicked truth are chosen once, of true models and in bounded work", "[kicks]") {
  const Task task = task_of("3.31", {});
  AskedNeed asked;
  asked.as_engines = true;
  asked.kick = "t=0.5,speed=*0.5";
  const Need need =
      with_ways(need_of(task, asked), task, Reference(std::string(ODDITY_SOURCE) + "/reference"));
  REQUIRE(need.kicks->ways.size() >= 2);
  const Quantity slide =
      motion_at_frames(*task.entry->exercise.scene, task.parameters, horizon_of(need), Reference::nothing());
  for (const auto& [model, algorithm] : need.kicks->ways) {
    INFO(model << " by " << algorithm);
    CHECK(model.find("regularized") == std::string::npos);
    CHECK(method_of(slide, model, algorithm)->run(1e-13).evaluations <= 2000 * slide.samples);
  }
}

TEST_CASE("no trial errs by less than its kicked truth is known to", "[kicks]") {
  Task task = task_of("3.5", {});
  const Need need = with_kick(task, "t=1s,theta'=+2");
  task.frames = horizon_of(need);
  task.kicks = need.kicks;
  const Results results =
      run(std::span(&task, 1), Reference(std::string(ODDITY_SOURCE) + "/reference"), false);
  const QuantityResult& swing = results.exercises[0].quantities[0];
  CHECK(swing.reference_error > 0);
  for (const MethodResult& method : swing.methods)
    for (const TimedTrial& trial : method.trials) CHECK(!(trial.error < swing.reference_error));
}

TEST_CASE("the truth after a kick is right to twelve digits, without constraints to drift from", "[kicks]") {
  const Task task = task_of("3.5", {});
  AskedNeed asked;
  asked.as_engines = true;
  asked.kick = "t=1s,theta'=+2";
  const Need need = need_of(task, asked);
  const Quantity known = known_motion(*task.entry->exercise.scene, task.parameters, horizon_of(need), need,
                                      Reference(std::string(ODDITY_SOURCE) + "/reference"));
  CHECK(near(*(known.reference.value.end() - 1), 0.7630067808538, 2e-12));
  CHECK(known.reference.by.starts_with("one angle by "));
}

TEST_CASE("choose takes a kick, and reports that it leaves closed forms out", "[kicks]") {
  const Task task = task_of("3.5", {});
  const Need need = with_kick(task, "t=1s,theta'=+2");
  const Choice choice = choose(task, need, Reference(std::string(ODDITY_SOURCE) + "/reference"),
                               [](const Method& m, double setting) {
                                 return Time{1e-9 * static_cast<double>(m.run(setting).evaluations), 0};
                               });
  REQUIRE(choice.chosen);
  CHECK(choice.chosen->error <= 1);
  for (const Candidate& c : choice.candidates)
    if (c.algorithm == "closed form") CHECK(c.outcome == Outcome::raised);
}

TEST_CASE("blanks and two signs in a row do not change a kick", "[kicks]") {
  const Task task = task_of("3.5", {});
  const auto kick_of = [&](const std::string& text) { return with_kick(task, text).kicks->front(); };
  for (const char* text : {"t=1s,theta'=-2", "t=1s,theta'=+-2", " t = 1 s , theta' = - 2 rad/s "}) {
    INFO(text);
    const Kick kick = kick_of(text);
    CHECK((kick.time == 1 && kick.of_rate && kick.change == Kick::Change::adds && kick.value == -2));
  }
  CHECK(kick_of("t=1s,theta'= * 2").value == 2);
  CHECK(with_kick(task, "t=1s,theta'=+2;t=1.5s,theta=+1;").kicks->size() == 2);
}

TEST_CASE("a kick in parentheses sets a value of either sign", "[kicks]") {
  const Task task = task_of("3.5", {});
  for (const auto& [text, value] :
       {std::pair("theta=(-0.25)", -0.25), std::pair("theta=( 0.25 rad )", 0.25)}) {
    INFO(text);
    const Kick kick = with_kick(task, "t=1s," + std::string(text)).kicks->front();
    CHECK((kick.change == Kick::Change::sets && kick.value == value));
  }
}

TEST_CASE("an impossible kick is refused, with a remedy", "[kicks]") {
  const auto refused = [](const std::string& exercise, const std::string& kick, const std::string& why) {
    INFO(kick);
    const std::string said = complaint([&] { with_kick(task_of(exercise, {}), kick); });
    INFO(said);
    CHECK(said.find(why) != std::string::npos);
  };
  refused("3.5", "theta'=+2", "begins with no time");
  refused("3.5", "t=1s", "changes nothing");
  refused("3.5", "t=3s,theta'=+2", "not within the horizon of 2 s");
  refused("3.5", "t=0,theta'=+2", "not within the horizon");
  refused("3.5", "t=1s,phi'=+2", "knows no 'phi' here: the names are theta, theta', and speed");
  refused("3.5", "t=1s,theta'=", "not name=value");
  refused("3.5", "t=1s,theta'=()", "''");
  refused("3.5", "t=1s,theta'=+2m", "'2m'");
  refused("3.5", "t=1s,speed=+2", "speed takes a factor");
  refused("3.5", "t=1s,theta'=nan", "'nan'");
  refused("3.5", "t=2s,theta'=+2", "is at 2 s, which is not within the horizon of 2 s, its ends excluded");
  refused("3.5", "t=1s,speed'=*2", "speed is a rate already, as in speed=*0.5");
  refused("3.5", "t=1s,theta'==2", "not name=value");
  refused("3.5", "t=1s,theta'=+2m", "as in \"t=1s,theta'=+2rad/s\"");
  refused("3.7", "t=1s,z=+2s", "as in \"t=1s,x'=+2m/s\"");
  const Task wire = task_of("3.7", {});
  const Need off_the_wire = with_kick(wire, "t=1s,y'=+1");
  const std::string said = complaint([&] {
    known_motion(*wire.entry->exercise.scene, wire.parameters, horizon_of(off_the_wire), off_the_wire,
                 Reference(std::string(ODDITY_SOURCE) + "/reference"));
  });
  CHECK(said.find("no state with the observables that the kick asks for") != std::string::npos);
}
