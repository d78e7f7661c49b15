// Events of a system: every algorithm of the catalog finds them as accurately as its motion. Also the two
// ways in which they end it.

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "chapters/numbers.hpp"
#include "report/verify/catch.hpp"
#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/catalog.hpp"
#include "solvers/ode/events.hpp"
#include "tests/near.hpp"

using namespace oddity;
using namespace oddity::ode;
using std::numbers::pi;

namespace {

using State = std::array<double, 2>;

/// q'' = -g - k q above a floor that returns the part e of the speed.
struct Bouncing {
  double g, k, e;
  mutable long calls = 0;

  void acceleration(const std::array<double, 1>& q, std::array<double, 1>& a) const {
    ++calls;
    a = {-g - k * q[0]};
  }
  template <class X>
  void operator()(const std::array<X, 2>& x, std::array<X, 2>& dxdt, const X&) const {
    ++calls;
    dxdt = {x[1], -g - k * x[0]};
  }
  std::array<double, 1> guards(const State& x, double) const { return {x[0]}; }
  Happening<State> at_event(std::size_t, const State& x, double) const { return {{0, -e * x[1]}}; }
};

template <class System>
MotionWithEvents<State> moved(std::string_view algorithm, const System& system, const State& start,
                              std::vector<double> times, double setting, std::size_t most = every_event) {
  const Adapted<AnySystem<2>, const System&> any(system);
  return integrate_with_events<2>(algorithm, any, start, times, setting, {}, most);
}

/// (v, direction of friction)
struct Sliding {
  template <class X>
  void operator()(const std::array<X, 2>& x, std::array<X, 2>& dxdt, const X&) const {
    dxdt = {-x[1], X(0)};
  }
  std::array<double, 1> guards(const State& x, double) const { return {x[0] * x[1]}; }
  Happening<State> at_event(std::size_t, const State& x, double) const { return {{x[0], -x[1]}}; }
};

/// With k = 1: it swings about -g as a cosine. Let go at rest at 1, then from bounce to bounce.
std::vector<double> trampoline_bounces(double g, double e, int count) {
  std::vector<double> times{std::acos(g / (1 + g))};
  double v = std::sqrt((1 + g) * (1 + g) - g * g);
  for (int i = 1; i < count; ++i) {
    v *= e;
    times.push_back(times.back() + 2 * std::atan(v / g));
  }
  return times;
}

double bounce_error(std::string_view algorithm, double setting, int bounce) {
  const auto motion = moved(algorithm, Bouncing{1, 1, 0.75}, {1, 0}, {0, 6}, setting);
  REQUIRE(motion.events.size() >= static_cast<std::size_t>(bounce));
  const auto at = static_cast<std::size_t>(bounce - 1);
  return std::abs(motion.events[at].time - trampoline_bounces(1, 0.75, bounce)[at]);
}

/// GSL's bsimp weighs errors by the size of the state alone, and finds no step from a state of 1e-30.
bool lost_near_zero(std::string_view name) { return name == "GSL bsimp"; }

constexpr double fine(Kind kind) { return has_tolerance(kind) ? 1e-9 : 0x1p-8; }

bool changes_order(std::string_view name) {
  return name == "GSL msadams" || name == "GSL msbdf" || name.starts_with("CVODE");
}

}  // namespace

TEST_CASE("the time of a third bounce shrinks with the step by the algorithm's order", "[events]") {
  for (const CatalogEntry& a : catalog()) {
    INFO(a.name);
    if (has_tolerance(a.kind) || a.order > 4) continue;
    const double order = std::log2(bounce_error(a.name, 0x1p-6, 3) / bounce_error(a.name, 0x1p-9, 3)) / 3;
    CHECK(near(order, a.order, 0.3));
  }
}

TEST_CASE("the error of a third bounce's time is proportional to the tolerance", "[events]") {
  for (const CatalogEntry& a : catalog()) {
    INFO(a.name);
    if (!has_tolerance(a.kind)) continue;
    // Algorithms that change their order start from the lowest at every bounce.
    for (double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
      INFO(tolerance);
      CHECK(bounce_error(a.name, tolerance, 3) < (changes_order(a.name) ? 3 * 200 : 10) * tolerance);
    }
    if (a.name != "GSL bsimp")  // its first steps are exact here
      CHECK(bounce_error(a.name, 1e-3, 3) > 20 * bounce_error(a.name, 1e-10, 3));
  }
}

TEST_CASE("a motion after its bounces is observed at the requested times, and all calls are counted",
          "[events]") {
  for (const CatalogEntry& a : catalog()) {
    INFO(a.name);
    const Bouncing ball{1, 1, 0.75};
    const auto motion = moved(a.name, ball, {1, 0}, {0, 1, 2, 3}, fine(a.kind));
    CHECK(motion.trajectory.reached());
    REQUIRE(motion.trajectory.value.size() == 4);
    const auto bounces = trampoline_bounces(1, 0.75, 2);
    const double v = 0.75 * std::sqrt(3), s = 2 - bounces[0];
    const double allowed = a.order == 1 ? 0.05 : 1e-4;
    CHECK(near(motion.trajectory.value[1][0], 2 * std::cos(1) - 1, allowed));
    CHECK(near(motion.trajectory.value[2][0], std::cos(s) - 1 + v * std::sin(s), allowed));
    if (a.kind != Kind::implicit_controlled && a.kind != Kind::implicit_fixed &&
        a.kind != Kind::self_stepping && a.kind != Kind::velocities_first)
      CHECK(motion.trajectory.evaluations == ball.calls);
  }
}

// ---- Zeno -------------------------------------------------------------------------------------------------

TEST_CASE("bounces that accumulate end at the sum of their times", "[events]") {
  const double g = 9.81, fall = std::sqrt(2 / g);
  for (double e : {0.0, 0.25, 0.5, 0.9}) {
    INFO(e);
    const double rest = fall * (1 + 2 * e / (1 - e));
    for (const CatalogEntry& a : catalog()) {
      INFO(a.name);
      if (a.order == 1 || lost_near_zero(a.name)) continue;  // with order 1 there is no parabola
      const double setting = has_tolerance(a.kind) ? 1e-9 : 0x1p-6;
      const auto motion = moved(a.name, Bouncing{g, 0, e}, {1, 0}, {0, 1, 10}, setting);
      CHECK(motion.trajectory.ending == Ending::chattering);
      CHECK(motion.trajectory.message.find("events without end") == 0);
      // A parabola is exact from order two on. Otherwise flights that are no higher than the error are lost.
      const bool exact = a.order > 1 && a.kind != Kind::implicit_controlled;
      const double error = changes_order(a.name) ? 200e-9 : 10e-9;
      CHECK(near(motion.events.back().time, rest,
                 exact ? 1e-13 / (1 - e) : 2 * std::sqrt(2 * error / g) / (1 - e)));
      CHECK(std::abs(motion.events.back().after[1]) < (exact ? 1e-12 : std::sqrt(2 * g * error)));
      if (e == 0.9 && exact) CHECK(motion.events.size() > 200);
    }
  }
}

TEST_CASE("explicit Euler's ball never comes to rest: each flight is a step too long", "[events]") {
  for (double h : {0x1p-6, 0x1p-8}) {
    const auto motion = moved("explicit Euler", Bouncing{9.81, 0, 0.5}, {1, 0}, {0, 10}, h);
    CHECK(motion.trajectory.reached());
    const auto& last = motion.events.back();
    const double flight = last.time - motion.events[motion.events.size() - 2].time;
    CHECK(near(flight / h, 3, 0.01));  // h (1 + e) / (1 - e)
  }
}

TEST_CASE("with the other Eulers the ball comes to rest one step too early for each of its bounces",
          "[events]") {
  for (const char* name : {"linearly implicit Euler", "symplectic Euler"}) {
    const auto steps_off = [&](int halvings) {
      const double h = std::pow(0.5, halvings);
      const auto motion = moved(name, Bouncing{9.81, 0, 0.5}, {1, 0}, {0, 10}, h);
      CHECK(motion.trajectory.ending == Ending::chattering);
      return (3 * std::sqrt(2 / 9.81) - motion.events.back().time) / h;
    };
    INFO(name);
    CHECK(steps_off(6) > 1);  // half the step means one bounce more, and its speed 1 + 2e / (1 - e) steps
    CHECK(near(steps_off(9) - steps_off(6), 9, 0.5));
    CHECK(near(steps_off(12) - steps_off(9), 9, 0.5));
  }
}

TEST_CASE("a law that changes its sign at rest chatters when both laws lead there", "[events]") {
  for (const CatalogEntry& a : catalog()) {
    if (a.kind == Kind::partitioned || lost_near_zero(a.name)) continue;
    INFO(a.name);
    const auto motion = moved(a.name, Sliding{}, {0.7, 1}, {0, 2}, has_tolerance(a.kind) ? 1e-6 : 0.1);
    CHECK(motion.trajectory.ending == Ending::chattering);
    CHECK(near(motion.events.back().time, 0.7, 1e-13));
    CHECK(near(motion.trajectory.value.back()[0], 0, 1e-13));
  }
}

// ---- grazing ----------------------------------------------------------------------------------------------

namespace {

/// Thrown up against a ceiling at 1; at its highest the ball is `beyond` it.
struct Thrown {
  double g;
  void acceleration(const std::array<double, 1>&, std::array<double, 1>& a) const { a = {-g}; }
  template <class X>
  void operator()(const std::array<X, 2>& x, std::array<X, 2>& dxdt, const X&) const {
    dxdt = {x[1], X(-g)};
  }
  std::array<double, 1> guards(const State& x, double) const { return {1 - x[0]}; }
  Happening<State> at_event(std::size_t, const State& x, double) const { return {{x[0], -x[1]}}; }
};
auto against_the_ceiling(std::string_view algorithm, double beyond, double setting) {
  return moved(algorithm, Thrown{2}, {0, 2 * std::sqrt(1 + beyond)}, {0, 1.9}, setting);
}

}  // namespace

TEST_CASE("a guard that only touches zero ends as grazing, one above or below it does not", "[events]") {
  for (const CatalogEntry& a : catalog()) {
    INFO(a.name);
    if (a.order == 1 || changes_order(a.name)) continue;  // its error is larger than reported
    const double setting = has_tolerance(a.kind) ? 1e-8 : 0x1p-5;
    const auto grazed = against_the_ceiling(a.name, 0, setting);
    CHECK(grazed.trajectory.ending == Ending::grazing);
    CHECK(grazed.trajectory.message.find("a guard touches zero at t = ") == 0);
    CHECK(grazed.events.empty());
    const double more = has_tolerance(a.kind) ? 1e-5 : 1e-10;
    const auto hit = against_the_ceiling(a.name, more, setting);
    CHECK(hit.trajectory.reached());
    CHECK(hit.events.size() == 1);
    const auto missed = against_the_ceiling(a.name, -more, setting);
    CHECK(missed.trajectory.reached());
    CHECK(missed.events.empty());
  }
}

TEST_CASE("the heights that count as grazing shrink like the error of a step", "[events]") {
  for (const char* name : {"explicit Euler", "symplectic Euler"}) {
    INFO(name);
    const auto untold = [&](double step) {
      int count = 0;
      for (int i = -2000; i < 2000; ++i)
        count += against_the_ceiling(name, i * 1e-4, step).trajectory.ending == Ending::grazing;
      return count;
    };
    const int coarse = untold(0x1p-3), fine_step = untold(0x1p-5);
    CHECK(fine_step > 0);
    CHECK(near(coarse / static_cast<double>(fine_step), 16, 8));
  }
}

// ---- stop, switch, and what is no event -------------------------------------------------------------------

TEST_CASE("a guard of the time is asked at its own time, within a step and at its end", "[events]") {
  struct Timed : Bouncing {
    double when;
    std::array<double, 1> guards(const State&, double t) const { return {when - t}; }
    Happening<State> at_event(std::size_t, const State& x, double) const { return {x, true}; }
  };
  for (const CatalogEntry& a : catalog())
    for (double when : {0.9, 1.0}) {
      INFO(a.name << ", at " << when);
      const auto motion =
          moved(a.name, Timed{{1, 1, 0}, when}, {9, 0}, {0, 1}, has_tolerance(a.kind) ? 1e-6 : 0.25);
      REQUIRE(motion.events.size() == 1);
      CHECK(near(motion.events[0].time, when, 1e-12));
    }
}

TEST_CASE("where a motion ends, its state stays", "[events]") {
  struct Stops : Bouncing {
    Happening<State> at_event(std::size_t, const State&, double) const { return {{0, 0}, true}; }
  };
  for (const CatalogEntry& a : catalog()) {
    INFO(a.name);
    const auto motion = moved(a.name, Stops{{1, 1, 0}}, {1, 0}, {0, 0.5, 2, 3}, fine(a.kind));
    CHECK(motion.trajectory.reached());
    CHECK(motion.events.size() == 1);
    REQUIRE(motion.trajectory.value.size() == 4);
    CHECK(motion.trajectory.value[1][0] > 0.5);
    CHECK(motion.trajectory.value[2] == State{0, 0});
    CHECK(motion.trajectory.value[3] == State{0, 0});
  }
}

namespace {

/// An oscillator.
struct Marked {
  void acceleration(const std::array<double, 1>& q, std::array<double, 1>& a) const { a = {-q[0]}; }
  template <class X>
  void operator()(const std::array<X, 2>& x, std::array<X, 2>& dxdt, const X&) const {
    dxdt = {x[1], -x[0]};
  }
  std::array<double, 1> guards(const State& x, double) const { return {x[0]}; }
  Happening<State> at_event(std::size_t, const State& x, double) const {
    return {.after = x, .passes = true};
  }
};

}  // namespace

TEST_CASE("an event that passes is found once, and a rising guard is no event", "[events]") {
  for (const CatalogEntry& a : catalog()) {
    INFO(a.name);
    const auto motion = moved(a.name, Marked{}, {1, 0}, {0, 21}, fine(a.kind));
    CHECK(motion.trajectory.reached());
    REQUIRE(motion.events.size() == 4);  // pi/2, and every 2 pi
    CHECK(near(motion.events[3].time, pi / 2 + 6 * pi, a.order == 1 ? 0.2 : 1e-2));
  }
}

TEST_CASE("a guard below zero that rises and falls within one step is seen where it falls", "[events]") {
  for (const char* name : {"velocity Verlet", "Runge-Kutta 4"}) {
    INFO(name);
    const auto motion = moved(name, Bouncing{1, 0, 1}, {-0.5, 2}, {0, 4}, 4);
    CHECK(motion.trajectory.reached());
    REQUIRE(motion.events.size() == 1);
    CHECK(near(motion.events[0].time, 2 + std::sqrt(3), 1e-14));
  }
}

namespace {

/// A guard of the time alone: (t - c)^2 - d, or less than that.
struct Dip : Bouncing {
  double c, d, sign = 1;
  std::array<double, 1> guards(const State&, double t) const { return {sign * ((t - c) * (t - c) - d)}; }
  Happening<State> at_event(std::size_t, const State& x, double) const {
    return {.after = x, .passes = true};
  }
};

}  // namespace

TEST_CASE("a guard that comes up to zero and no higher cannot fall, whether on a sample or a step's end",
          "[events]") {
  for (double touched : {1.0, 1.0625, 1.125}) {  // a step takes a quarter, and is looked at in four places
    INFO(touched);
    const auto motion = moved("Runge-Kutta 4", Dip{{1, 0, 0}, touched, 0, -1}, {9, 0}, {0, 3}, 0.25);
    CHECK(motion.trajectory.reached());
    CHECK(motion.events.empty());
  }
}

TEST_CASE("a guard that dips below zero between two samples is seen", "[events]") {
  for (double c : {0.1, 0.15, 0.3, 0.4, 0.6, 0.7, 0.85, 0.9}) {
    INFO(c);
    const auto motion = moved("Runge-Kutta 4", Dip{{1, 0, 0}, c, 1e-4}, {9, 0}, {0, 1}, 1);
    REQUIRE(motion.events.size() == 1);
    CHECK(near(motion.events[0].time, c - 0.01, 2e-14));
  }
}

TEST_CASE("a guard left in a step happens at once where another's event in it leads below", "[events]") {
  struct Trapdoor : Bouncing {  // thrown up from the floor, and put below it when it is half as fast
    std::array<double, 2> guards(const State& x, double) const { return {x[0], x[1] - 0.5}; }
    Happening<State> at_event(std::size_t i, const State& x, double) const {
      if (i == 0) return {x, true};
      return {.after = {-0.1, x[1]}, .passes = true};
    }
  };
  const auto motion = moved("Runge-Kutta 4", Trapdoor{{1, 0, 0}}, {0, 1}, {0, 2}, 1);
  REQUIRE(motion.events.size() == 2);
  CHECK(motion.events[0].guard == 1);
  CHECK(motion.events[1].guard == 0);
  CHECK(motion.events[1].time == motion.events[0].time);
}

TEST_CASE("two walls that are struck at once both strike", "[events]") {
  struct Corner {  // a point runs into a corner at unit speed in each direction
    void operator()(const std::array<double, 4>& x, std::array<double, 4>& dxdt, double) const {
      dxdt = {x[2], x[3], 0, 0};
    }
    std::array<double, 2> guards(const std::array<double, 4>& x, double) const { return {x[0], x[1]}; }
    Happening<std::array<double, 4>> at_event(std::size_t i, std::array<double, 4> x, double) const {
      x[2 + i] = -x[2 + i];
      return {x};
    }
  };
  for (double late : {0.0, 1e-15, -1e-15, 1e-9}) {
    INFO(late);
    const std::array times{0.0, 1.0};
    const auto motion =
        integrate_with_events<RungeKutta4>(Corner{}, std::array{0.3, 0.3 + late, -1.0, -1.0}, times, 0.0625);
    CHECK(motion.trajectory.reached());
    CHECK(motion.events.size() == 2);
    CHECK(near(motion.trajectory.value.back()[0], 0.7, 1e-12));
    CHECK(near(motion.trajectory.value.back()[1], 0.7 - late, 1e-12));
  }
}

TEST_CASE("a ball in contact with the floor at the start leaves it, or chatters on it", "[events]") {
  for (const char* name : {"velocity Verlet", "Runge-Kutta 4", "Dormand-Prince 5(4)", "GSL rk8pd"}) {
    INFO(name);
    const double setting = name[0] == 'D' || name[0] == 'G' ? 1e-8 : 0.125;
    const auto hop = moved(name, Bouncing{1, 0, 1}, {0, 1e-3}, {0, 1}, setting, 3);
    REQUIRE(hop.events.size() == 3);
    CHECK(near(hop.events[2].time, 6e-3, 1e-14));
    const auto still = moved(name, Bouncing{1, 0, 0.5}, {0, 0}, {0, 1}, setting);
    CHECK(still.trajectory.ending == Ending::chattering);
    CHECK(still.events.back().time == 0);
  }
}

TEST_CASE("a guard that is NaN, or jumps across a pole, is no event", "[events]") {
  struct Pole : Bouncing {
    std::array<double, 1> guards(const State& x, double) const { return {1 / x[0]}; }
  };
  struct Undefined : Bouncing {
    std::array<double, 1> guards(const State&, double) const { return {std::nan("")}; }
  };
  CHECK(moved("Runge-Kutta 4", Pole{{1, 1, 1}}, {1, 0}, {0, 2}, 0.01).events.empty());
  CHECK(moved("Runge-Kutta 4", Undefined{{1, 1, 1}}, {1, 0}, {0, 2}, 0.01).events.empty());
}

TEST_CASE("the first event, or the sentence that none happens", "[events]") {
  const Bouncing ball{1, 1, 0.75};
  const auto first = first_event<RungeKutta4>(ball, State{1, 0}, 0, 3, 0x1p-8);
  CHECK(first.reached());
  CHECK(near(first.value.time, pi / 3, 1e-9));
  CHECK(near(first.value.before[1], -std::sqrt(3), 1e-8));
  const auto none = first_event<RungeKutta4>(ball, State{1, 0}, 0, 1, 0x1p-8);
  CHECK(none.ending == Ending::raised);
  CHECK(none.message == "the event does not happen in the time given");
}
