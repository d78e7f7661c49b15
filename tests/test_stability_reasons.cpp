// The reasons in limits.csv for limits that differ from linear theory's, each shown on its rows. Also the
// mark of limits without a sharp value.

#include <cmath>
#include <numbers>

#include "chapters/scene.hpp"
#include "report/study/stability.hpp"
#include "report/verify/catch.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

struct Row {
  Number number;
  const char *model, *algorithm;
};

/// A row's method, and the time between two looks at its motion.
struct Found {
  Method method;
  double interval;
};

Found method_in(const Row& row) {
  for (const Entry& entry : registry())
    if (entry.number == row.number) {
      const Scene& scene = *entry.exercise.scene;
      const Quantity q =
          motion(scene, Parameters(entry.exercise.parameters), Horizon{scene.horizon}, Reference::nothing());
      return {*method_of(q, row.model, row.algorithm), scene.horizon / q.samples};
    }
  throw std::logic_error("no such scene");
}

Limit limit_in(const Found& found, const ode::Criteria& criteria = {}) {
  return measured_limit(found.method, found.interval, criteria);
}

bool same(double a, double b) { return a == b || std::abs(a - b) <= 0.05 * std::max(a, b); }

/// Rows with sharp limits, and rows without, with the observers who find other limits.
const std::vector<Row> sharp{
    {{3, 23}, "one angle", "symplectic Euler"}, {{3, 5}, "one angle", "velocity Verlet"},
    {{3, 5}, "one angle", "Runge-Kutta 4"},     {{3, 5}, "one angle", "explicit Euler"},
    {{3, 3}, "Cartesian", "McLachlan 4"},       {{3, 3}, "polar", "Runge-Kutta 4"},
    {{3, 23}, "one angle", "Runge-Kutta 4"},    {{3, 23}, "one angle", "velocity Verlet"}};
struct Moved {
  Row row;
  ode::Criteria by;
};
const std::vector<Moved> soft{
    {{{3, 5}, "Cartesian with constraint", "Runge-Kutta 4"}, {.radians = 500}},
    {{{3, 5}, "one angle", "modified midpoint"}, {.radians = 2000}},
    {{{3, 13}, "angle about the axis", "Adams-Bashforth-Moulton 6"}, {.radians = 2000}},
    {{{3, 15}, "along the rod, with the work", "Runge-Kutta 4"}, {.radians = 2000}},
    {{{3, 5}, "one angle", "Adams-Bashforth 4"}, {.largest_size = 4}},
    {{{3, 3}, "Cartesian", "velocity Verlet"}, {.largest_size = 1.5}}};

}  // namespace

TEST_CASE("a sharp limit is the same for half or twice the time, or for another size", "[stability]") {
  for (const Row& row : sharp) {
    const Found found = method_in(row);
    const Limit usual = limit_in(found);
    INFO(row.model << ", " << row.algorithm << ": " << usual.step());
    CHECK_FALSE(usual.soft);
    for (const ode::Criteria& c : {ode::Criteria{.radians = 500}, ode::Criteria{.radians = 2000},
                                   ode::Criteria{.largest_size = 1.5}, ode::Criteria{.largest_size = 4}}) {
      INFO(c.radians << " rad, size " << c.largest_size);
      CHECK(same(limit_in(found, c).step(), usual.step()));
    }
  }
}

TEST_CASE("a limit that differs for another observer is marked, and the other limit is in the marked range",
          "[stability]") {
  for (const auto& [row, by] : soft) {
    const Found found = method_in(row);
    const Limit usual = limit_in(found), other = limit_in(found, by);
    INFO(row.model << ", " << row.algorithm << ": " << usual.stable << ", " << other.stable);
    CHECK_FALSE(same(usual.stable, other.stable));
    REQUIRE(usual.soft);
    CHECK(usual.soft->least <= 1.02 * other.stable);
    CHECK(usual.soft->most >= 0.98 * other.stable);
    CHECK(usual.soft->most > 1.05 * usual.soft->least);
  }
}

TEST_CASE("a motion that is lost only in the second thousand radians has its limit marked", "[stability]") {
  const Found found = method_in({{3, 17}, "two angles", "linearly implicit Euler"});
  const Limit limit = limit_in(found);
  const Disturbances disturbances = found.method.disturbances({});
  CHECK(limit.unstable == 0);
  REQUIRE(limit.soft);
  const double lost = disturbances.lost(1.01 * limit.soft->least).time(1);
  INFO("lost after " << lost);
  CHECK((lost > disturbances.span && lost <= disturbances.watched));
}

TEST_CASE("no sharp limit depends on how far motions may diverge", "[stability]") {
  const std::vector<ode::Criteria> others{{.granted = 50}, {.granted = 200}, {.as_fast = 1}, {.as_fast = 4}};
  for (const Row& row : sharp) {
    const Found found = method_in(row);
    const double usual = limit_in(found).step();
    for (const ode::Criteria& c : others) {
      INFO(row.model << ", " << row.algorithm << ": granted " << c.granted << ", as fast " << c.as_fast);
      CHECK(same(limit_in(found, c).step(), usual));
    }
  }
}

namespace {

/// A row's limit with this reason, and the disturbances that were used to measure it.
struct Explained {
  Found found;  ///< owns the model that the disturbances refer to
  Limit limit;
  Disturbances disturbances;
};

Explained because(const std::string& reason, const Row& row) {
  const Found found = method_in(row);
  Explained e{found, limit_in(found), found.method.disturbances({})};
  INFO(row.model << ", " << row.algorithm << ": " << e.limit.why << " (" << e.limit.evidence << ")");
  CHECK(e.limit.why.starts_with(reason));
  return e;
}

/// Whether a disturbance of the true motion is lost if only the method's steps act on it.
bool lost_along_truth(const Explained& e, double step) {
  return e.disturbances.lost_along_truth(step) <= e.disturbances.span;
}

}  // namespace

TEST_CASE("reason: the growth by theory does not add up to a loss", "[stability]") {
  const Explained slide =
      because("growth that theory finds at single points", {{3, 7}, "one coordinate", "explicit Euler"});
  CHECK(slide.limit.step() > 10 * slide.limit.theory());
  CHECK(slide.disturbances.added_growth(slide.limit.stable) <= std::log(100));
  CHECK_FALSE(lost_along_truth(slide, slide.limit.stable));
}

TEST_CASE("reason: theory freezes the motion", "[stability]") {
  // Above theory, although its growth adds up; and below it, where nothing grows on the frozen motion.
  const Explained slide = because("theory freezes", {{3, 7}, "one coordinate", "Adams-Bashforth 4"});
  CHECK(slide.limit.step() > 2 * slide.limit.theory());
  CHECK(slide.disturbances.added_growth(slide.limit.stable) > std::log(100));
  CHECK_FALSE(lost_along_truth(slide, slide.limit.stable));
  const Explained planet = because("theory freezes", {{3, 3}, "Cartesian", "McLachlan 4"});
  CHECK(planet.limit.step() < 0.8 * planet.limit.theory());
  bool lost = false;
  for (double part = 1; part < 1.25; part *= 1.01)
    lost = lost || lost_along_truth(planet, part * planet.limit.stable);
  CHECK(lost);
  CHECK_FALSE(lost_along_truth(planet, 0.8 * planet.limit.stable));
}

TEST_CASE("reason: theory holds for the true motion, but the method makes another", "[stability]") {
  for (const char* algorithm : {"explicit Euler", "modified midpoint"}) {
    const Explained disk = because("theory is right for the true motion", {{3, 21}, "one angle", algorithm});
    CHECK_FALSE(lost_along_truth(disk, 0.8 * disk.limit.theory()));
    CHECK(lost_along_truth(disk, 1.25 * disk.limit.theory()));
    CHECK(disk.disturbances.lost(0.99 * disk.limit.stable).time(1) > disk.disturbances.span);
  }
}

TEST_CASE("reason: resonance, where four steps of symplectic Euler make one swing", "[stability]") {
  for (const Number number : {Number{3, 5}, Number{3, 23}}) {
    const Explained swing = because("resonance", {number, "one angle", "symplectic Euler"});
    CHECK(near(swing.disturbances.turns_in_a_step(0.995 * swing.limit.stable), 0.25, 0.002));
    CHECK(near(swing.disturbances.turns_in_a_step(swing.limit.stable / 2), 0.115, 0.01));
  }
  // Verlet's orbit of the planet does not take a whole number of steps.
  CHECK_FALSE(limit_in(method_in({{3, 3}, "Cartesian", "McLachlan 4"})).why.starts_with("resonance"));
}

TEST_CASE("reason: the method's own motion becomes much faster than the true one", "[stability]") {
  const Explained planet =
      because("before the loss the method moves faster", {{3, 3}, "Cartesian", "linearly implicit Euler"});
  const auto own = [&](double until) { return planet.disturbances.own_theory(planet.limit.unstable, until); };
  CHECK(own(planet.limit.lost) < planet.limit.theory() / 2);
  CHECK(own(planet.limit.lost) < own(planet.limit.lost / 2));  // it spirals in
}

TEST_CASE("growth adds up along a motion, minus the allowed growth", "[stability]") {
  const std::complex<double> i(0, 1);
  const ode::Spectrum half_unstable{1, {{i}, {0.0}}};
  CHECK(near(ode::added_growth("explicit Euler", half_unstable, 0.1, 10, 2),
             10 * std::log(1.01) / 2 / 0.1 / 2, 1e-12));
  CHECK(near(ode::added_growth("explicit Euler", {1, {{1.0}}}, 0.1, 10, 2), 10 * (std::log(1.1) / 0.1 - 2),
             1e-12));
}

TEST_CASE(
    "half or twice the negligible growth changes no limit of theory except the modified midpoint rule's",
    "[stability]") {
  const ode::Spectrum turning{10, {{{0, 1}, {0, -1}}}};
  for (const char* algorithm : {"symplectic Euler", "velocity Verlet", "Runge-Kutta 4", "McLachlan 4",
                                "Adams-Bashforth 4", "Adams-Bashforth-Moulton 6", "modified midpoint"}) {
    const auto first = [&](double factor) {
      return ode::unstable_steps(algorithm, turning, factor * ode::negligible_growth).front().from;
    };
    INFO(algorithm << ": " << first(0.5) << ", " << first(1) << ", " << first(2));
    const bool moved = !same(first(0.5), first(1)) || !same(first(2), first(1));
    CHECK(moved == (std::string(algorithm) == "modified midpoint"));
  }
}
