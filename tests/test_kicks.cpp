// Kicks from outside, beside loops by hand.

#include "report/study/kicks.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

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

/// The angle at each sixtieth of a second up to 2 s, where the rate at 1 s becomes what `kick` makes of it.
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

TEST_CASE("a kick changes what is seen, in whatever state a model has", "[kicks]") {
  const Task task = task_of("3.5", {});
  const Scene& scene = *task.entry->exercise.scene;
  struct Jolt {
    std::string kick;
    std::vector<double> expected;
    bool keeps_rod = true;  ///< in Cartesian coordinates the nearest state that is seen so
  };
  for (const Jolt& jolt :
       {Jolt{"t=1s,theta'=+2", by_hand([](State& x) { x[1] += 2; })},
        Jolt{"t=1s,theta'=60deg/s", by_hand([](State& x) { x[1] = std::numbers::pi / 3; })},
        Jolt{"t=1s,speed=*-0.5", by_hand([](State& x) { x[1] *= -0.5; })},
        Jolt{"t=1s,theta=0.1,theta'=-1", by_hand([](State& x) {
               x = {0.1, x[1] - 1};
             }),
             false}}) {
    INFO(jolt.kick);
    const Need need = with_kick(task, jolt.kick);
    const Quantity swing =
        motion_at_frames(scene, task.parameters, horizon_of(need), Reference::nothing(), need.kicks);
    for (const char* model : {"one angle", "Cartesian with constraint"}) {
      INFO(model);
      const Method* method = method_of(swing, model, "Fehlberg 7(8)");
      REQUIRE(method);
      if (model != std::string("one angle") && !jolt.keeps_rod) {
        CHECK(method->run(1e-13).ending == Ending::raised);
        continue;
      }
      CHECK(off(method->run(1e-13).value, jolt.expected) < 1e-8);
    }
    const Answer closed = method_of(swing, "small angle", "closed form")->run(0);
    CHECK(closed.ending == Ending::raised);
    CHECK(closed.message == "it knows no kick");
    const Quantity known = known_motion(scene, task.parameters, horizon_of(need), need,
                                        Reference(std::string(ODDITY_SOURCE) + "/reference"));
    CHECK(off(known.reference.value, jolt.expected) < 1e-8);
    CHECK(known.reference_error < 1e-7);
    CHECK(known.reference_error > 0);
  }
}

TEST_CASE("steps of one length begin anew at a kick, which may come between frames", "[kicks]") {
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

TEST_CASE("choose takes a kick, leaves closed forms out, and says so", "[kicks]") {
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

TEST_CASE("a kick that cannot be is refused with what would be right", "[kicks]") {
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
  refused("3.5", "t=1s,phi'=+2", "knows no 'phi' here: what is seen is theta, theta', and speed");
  refused("3.5", "t=1s,theta'=", "not name=value");
  refused("3.5", "t=1s,theta'=+2m", "'2m'");
  refused("3.5", "t=1s,speed=+2", "speed takes a factor");
  refused("3.5", "t=1s,theta'=nan", "'nan'");
  const Task wire = task_of("3.7", {});
  const Need off_the_wire = with_kick(wire, "t=1s,y'=+1");
  const std::string said = complaint([&] {
    known_motion(*wire.entry->exercise.scene, wire.parameters, horizon_of(off_the_wire), off_the_wire,
                 Reference(std::string(ODDITY_SOURCE) + "/reference"));
  });
  CHECK(said.find("no state that is seen as the kick would have it") != std::string::npos);
}
