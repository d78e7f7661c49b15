// Events with a known time, and the result when there is no event. An event must be as accurate as the
// states.

#include <numbers>

#include "report/verify/catch.hpp"
#include "solvers/ode/events.hpp"
#include "tests/near.hpp"
#include "tests/ode_algorithms.hpp"

using namespace oddity;
using namespace oddity::ode;
using namespace problems;
using std::numbers::pi;

namespace {

double height(const State& x, double) { return x[0]; }

template <class Algorithm>
auto crossing(const Problem& problem, double t0, double t1, double setting) {
  return find_event<Algorithm>(problem.system, problem.exact(t0), t0, t1, setting, height);
}

}  // namespace

TEST_CASE("every algorithm finds a pendulum's and an oscillator's crossing, forward and backward",
          "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    const double allowed = !has_tolerance(Algorithm::kind) ? 3e-3 : changes_order<Algorithm> ? 5e-7 : 1e-8;
    for (double direction : {1.0, -1.0}) {
      const auto quarter = crossing<Algorithm>(oscillator, 0, 10 * direction, fine<Algorithm>);
      CHECK(quarter.reached());
      CHECK(near(quarter.value.time, direction * pi / 2, allowed));
      CHECK(near(quarter.value.state[0], 0, 1e-12));
      CHECK(near(quarter.value.state[1], -direction, allowed));

      const auto lowest = crossing<Algorithm>(separatrix, -1.5 * direction, 1.5 * direction, fine<Algorithm>);
      CHECK(lowest.reached());
      CHECK(near(lowest.value.time, 0, allowed));
    }
  });
}

TEST_CASE("an event's error shrinks with the step by the algorithm's order", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    if constexpr (!has_tolerance(Algorithm::kind)) {
      const auto error = [](double step) {
        return std::abs(crossing<Algorithm>(separatrix, -1.5, 1.5, step).value.time);
      };
      if (Algorithm::order > 4) return;  // too near to rounding
      CHECK(near(std::log2(error(0x1p-6) / error(0x1p-7)), Algorithm::order, 0.4));
    }
  });
}

TEST_CASE("an event's error is proportional to the tolerance", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    if constexpr (has_tolerance(Algorithm::kind)) {
      for (double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12}) {
        const auto event = crossing<Algorithm>(separatrix, -1.5, 1.5, tolerance);
        CHECK(event.reached());
        CHECK(std::abs(event.value.time) < (changes_order<Algorithm> ? 200 : 10) * tolerance);
      }
    }
  });
}

TEST_CASE("a parabola is exact for every algorithm of order two and more", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    const auto event = crossing<Algorithm>(fall, 0, 2, has_tolerance(Algorithm::kind) ? 1e-6 : 0x1p-7);
    bool exact = true;
    if constexpr (!has_tolerance(Algorithm::kind)) exact = Algorithm::order > 1;
    if (changes_order<Algorithm> || Algorithm::kind == Kind::implicit_controlled) exact = false;
    CHECK(event.reached());
    CHECK(near(event.value.time, std::sqrt(4 / 9.81), exact ? 1e-14 : 0.01));
  });
}

TEST_CASE("a ball bounces: event after event, each with half of the height", "[solvers]") {
  // From height 2 with restitution sqrt(1/2): the flights last T, 2T/sqrt 2, 2T/2, ... with T = sqrt(4/g).
  double t = 0, expected = std::sqrt(4 / 9.81);
  State x{2, 0};
  for (int bounce = 0; bounce < 8; ++bounce) {
    const auto event = find_event<RungeKutta4>(fall.system, x, t, t + 5, 0x1p-6, height);
    REQUIRE(event.reached());
    CHECK(near(event.value.time, expected, 1e-13));
    t = event.value.time;
    x = {0, -event.value.state[1] * std::sqrt(0.5)};
    expected += 2 * std::sqrt(4 / 9.81) * std::pow(0.5, (bounce + 1) / 2.0);
  }
}

TEST_CASE("an event at the start is not reported", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    const auto event = find_event<Algorithm>(oscillator.system, State{0, 1}, 0, 10, fine<Algorithm>, height);
    CHECK(event.reached());
    CHECK(near(event.value.time, pi, 5e-3));
  });
}

TEST_CASE("an event just after the start is found to its last digits, also at large t", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    const double t0 = 1000;
    const auto event =
        find_event<Algorithm>(oscillator.system, State{1e-9, -1}, t0, t0 + 1, fine<Algorithm>, height);
    CHECK(event.reached());
    CHECK(near(event.value.time - t0, 1e-9, 2e-13));
    CHECK(near(event.value.state[0], 0, 2e-13));
  });
}

TEST_CASE("an event at a step's end or at a sample is found", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    for (double event_time : {0.5, 0.3, 0.25, 0.1, 1.0}) {
      const auto line = [=](const State&, double t) { return t - event_time; };
      const auto event = find_event<Algorithm>(oscillator.system, State{1, 0}, 0, 1,
                                               has_tolerance(Algorithm::kind) ? 1e-6 : 0.1, line);
      CHECK(event.reached());
      CHECK(near(event.value.time, event_time, 1e-15));
    }
  });
}

TEST_CASE("a double crossing at the limit of rounding is found", "[solvers]") {
  // g = 0 at 2.99 and 3.01, which are both ends of steps.
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    const auto dip = [](const State&, double t) { return (t - 3) * (t - 3) - 1e-4; };
    if constexpr (!has_tolerance(Algorithm::kind))
      for (double step : {0.1, 0.01, 0.001}) {
        const auto event = find_event<Algorithm>(oscillator.system, State{1, 0}, 0.1, 6, step, dip);
        CHECK(event.reached());
        CHECK(near(event.value.time, 2.99, 1e-14));
      }
  });
}

TEST_CASE("a double crossing is found if it lasts a quarter of a step, and may be missed below",
          "[solvers]") {
  const auto dip = [](double width) {
    return [=](const State&, double t) { return (t - 0.55) * (t - 0.55) - width * width / 4; };
  };
  const auto find = [](const auto& g) {
    return find_event<RungeKutta4>(oscillator.system, State{1, 0}, 0, 2, 0.2, g);
  };
  CHECK(find(dip(0.051)).reached());
  CHECK(near(find(dip(0.051)).value.time, 0.55 - 0.0255, 1e-12));
  CHECK(find([](const State&, double t) { return (t - 0.575) * (t - 0.575) - 1e-4; }).ending ==
        Ending::raised);
}

TEST_CASE("without an event in the given time, every algorithm reports it", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    const auto none = crossing<Algorithm>(oscillator, 0, 1, fine<Algorithm>);
    CHECK(none.ending == Ending::raised);
    CHECK(none.message == "the event does not happen in the time given");
    CHECK(none.evaluations > 0);
  });
}

TEST_CASE("a change of sign is found even if the product of both sides underflows or overflows",
          "[solvers]") {
  const auto usual = [](const State& x, double) { return x[0]; };
  const auto tiny = [](const State& x, double) { return 0x1p-700 * x[0]; };
  for_each_algorithm([&]<class Algorithm>() {
    INFO(Algorithm::name);
    const auto event = find_event<Algorithm>(oscillator.system, State{1, 0}, 0, 4, fine<Algorithm>, tiny);
    CHECK(event.reached());
    const auto same = find_event<Algorithm>(oscillator.system, State{1, 0}, 0, 4, fine<Algorithm>, usual);
    CHECK(event.value.time == same.value.time);
  });
}

TEST_CASE("a change of sign at a pole of g is not an event", "[solvers]") {
  const auto pole_of_g = [](const State& x, double) { return 1 / x[0]; };
  for_each_algorithm([&]<class Algorithm>() {
    INFO(Algorithm::name);
    const auto event =
        find_event<Algorithm>(oscillator.system, State{1, 0}, 0, 4, fine<Algorithm>, pole_of_g);
    CHECK(event.ending == Ending::raised);
  });
}

TEST_CASE("a g of NaN, a bad setting and a motion that fails find no event", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    const auto undefined = [](const State&, double) { return std::numeric_limits<double>::quiet_NaN(); };
    CHECK_FALSE(
        find_event<Algorithm>(oscillator.system, State{1, 0}, 0, 4, fine<Algorithm>, undefined).reached());
    CHECK(crossing<Algorithm>(oscillator, 0, 4, 0).ending == Ending::raised);
    // Linearly implicit Euler and a multistep method step over the pole, and see a change of sign there.
    if constexpr (!std::is_same_v<Algorithm, ImplicitEuler> && !multistep<Algorithm>)
      CHECK_FALSE(crossing<Algorithm>(pole, 0, 2, has_tolerance(Algorithm::kind) ? 1e-6 : 1e-2).reached());
  });
}

TEST_CASE("the evaluations of an event are all calls made, including those inside steps", "[solvers]") {
  for_each_algorithm([]<class Algorithm>() {
    INFO(Algorithm::name);
    if (info<Algorithm>().by_series) return;                // it makes none
    if (Algorithm::kind == Kind::velocities_first) return;  // it looks for the velocities before its steps
    const System system{oscillator.system.f};
    const auto event = find_event<Algorithm>(system, State{1, 0}, 0, 10, fine<Algorithm>, height);
    CHECK(event.evaluations == system.calls);
    const auto alone =
        integrate<Algorithm>(oscillator.system, State{1, 0}, 0, event.value.time, fine<Algorithm>);
    CHECK(event.evaluations > alone.evaluations);
  });
}
