// The reasons that limits.csv gives for limits which differ from linear theory's, each shown on its rows, and
// the mark of limits that have no sharp value.

#include <cmath>
#include <numbers>

#include "chapters/scene.hpp"
#include "report/stability.hpp"
#include "tests/catch.hpp"
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

/// Rows that are sharp, and rows that are lost slowly.
const std::vector<Row> sharp{
    {{3, 5}, "one angle", "symplectic Euler"},  {{3, 5}, "one angle", "velocity Verlet"},
    {{3, 5}, "one angle", "Runge-Kutta 4"},     {{3, 5}, "one angle", "Adams-Bashforth 4"},
    {{3, 5}, "one angle", "explicit Euler"},    {{3, 3}, "Cartesian", "velocity Verlet"},
    {{3, 3}, "Cartesian", "McLachlan 4"},       {{3, 3}, "polar", "Runge-Kutta 4"},
    {{3, 23}, "one angle", "symplectic Euler"}, {{3, 23}, "one angle", "Runge-Kutta 4"},
    {{3, 23}, "one angle", "velocity Verlet"}};
const std::vector<Row> slow{{{3, 5}, "Cartesian with constraint", "Runge-Kutta 4"},
                            {{3, 5}, "one angle", "modified midpoint"},
                            {{3, 3}, "Cartesian", "Runge-Kutta 4"},
                            {{3, 23}, "Cartesian with constraint", "Runge-Kutta 4"}};

}  // namespace

TEST_CASE("a limit is the same when watched half or twice as long, or is marked", "[stability]") {
  for (const auto& [rows, marked] : {std::pair(sharp, false), std::pair(slow, true)})
    for (const Row& row : rows) {
      const Found found = method_in(row);
      const Limit usual = limit_in(found), half = limit_in(found, {.radians = 500}),
                  twice = limit_in(found, {.radians = 2000});
      INFO(row.model << ", " << row.algorithm << ": " << half.step() << ", " << usual.step() << ", "
                     << twice.step());
      CHECK(usual.halved.has_value() == marked);
      CHECK((same(half.step(), usual.step()) && same(usual.step(), twice.step())) == !marked);
    }
}

TEST_CASE("of the sharp limits two hang on how large a motion may become, none on how far it may part",
          "[stability]") {
  const auto hangs = [](const Row& row, const ode::Criteria& c) {
    const std::string_view algorithm = row.algorithm;
    return (row.number == Number{3, 5} && algorithm == "Adams-Bashforth 4" && c.largest_size == 4) ||
           (row.number == Number{3, 3} && algorithm == "velocity Verlet" && c.largest_size == 1.5);
  };
  const std::vector<ode::Criteria> others{{.granted = 50}, {.granted = 200},      {.as_fast = 1},
                                          {.as_fast = 4},  {.largest_size = 1.5}, {.largest_size = 4}};
  for (const Row& row : sharp) {
    const Found found = method_in(row);
    const double usual = limit_in(found).step();
    for (const ode::Criteria& c : others) {
      INFO(row.model << ", " << row.algorithm << ": granted " << c.granted << ", as fast " << c.as_fast
                     << ", size " << c.largest_size);
      CHECK(same(limit_in(found, c).step(), usual) == !hangs(row, c));
    }
  }
}

TEST_CASE("reason: what theory has grow does not add up to a loss", "[stability]") {
  for (const Row& row : {Row{{3, 15}, "Cartesian with constraints", "explicit Euler"},
                         Row{{3, 21}, "one angle", "modified midpoint"}}) {
    const Found found = method_in(row);
    const Limit limit = limit_in(found);
    INFO(row.model << ", " << row.algorithm << ": " << limit.why);
    CHECK(limit.why.starts_with("what theory has grow at some points"));
    CHECK(limit.step() > 1.25 * limit.theory());
    CHECK(found.method.disturbances({}).added_growth(limit.stable) <= std::log(100));
  }
  // Where it does add up, and the method is stable all the same, that is no reason.
  CHECK(limit_in(method_in({{2, 7}, "quaternion", "Adams-Bashforth 4"})).why == not_explained);
}

TEST_CASE("reason: the method's own motion becomes much faster than the true one", "[stability]") {
  const Found found = method_in({{3, 3}, "Cartesian", "linearly implicit Euler"});
  const Limit limit = limit_in(found);
  CHECK(limit.why.starts_with("before it is lost the method's own motion"));
  const auto own = [&](double until) {
    return found.method.disturbances({}).own_theory(limit.unstable, until);
  };
  CHECK(own(limit.lost) < limit.theory() / 2);
  CHECK(own(limit.lost) < own(limit.lost / 2));  // it spirals in
  // McLachlan's orbit does not: theory's limit along it stays above half, and explains nothing.
  CHECK(limit_in(method_in({{3, 3}, "Cartesian", "McLachlan 4"})).why == not_explained);
}

TEST_CASE("growth adds up along a motion, less what may grow", "[stability]") {
  const std::complex<double> i(0, 1);
  const ode::Spectrum half_unstable{1, {{i}, {0.0}}};
  CHECK(near(ode::added_growth("explicit Euler", half_unstable, 0.1, 10, 2),
             10 * std::log(1.01) / 2 / 0.1 / 2, 1e-12));
  CHECK(near(ode::added_growth("explicit Euler", {1, {{1.0}}}, 0.1, 10, 2), 10 * (std::log(1.1) / 0.1 - 2),
             1e-12));
}

TEST_CASE("half or twice the negligible growth moves no limit of theory but the modified midpoint rule's",
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
