#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "chapters/02_basic_concepts/07_curve_on_sphere/models.hpp"
#include "chapters/03_rigid_body_motion/35_moving_tip/moving_tip.hpp"
#include "chapters/contents.hpp"
#include "reference/bad_input.hpp"
#include "reference/reference.hpp"
#include "report/study/run.hpp"
#include "report/verify/catch.hpp"
#include "solvers/ode/algorithms.hpp"
#include "solvers/ode/integrate.hpp"
#include "tests/near.hpp"

using namespace oddity;

namespace {

/// Every real parameter a quarter larger, or smaller where its range ends; a seed is not changed.
Parameters off_defaults(const Entry& entry) {
  Parameters p(entry.exercise.parameters);
  for (const Parameter& letter : p.declared()) {
    if (letter.whole || letter.name == "seed") continue;
    const double more = 1.25 * letter.value, less = 0.8 * letter.value;
    const auto allowed = [&](double x) { return letter.least <= x && x <= letter.most; };
    if (allowed(more) || allowed(less)) p.set(letter.name, allowed(more) ? more : less);
  }
  return p;
}

const Entry& entry_of(int chapter, int index) {
  return *std::ranges::find(registry(), Number{chapter, index}, &Entry::number);
}

const Reference& reference() {
  static const Reference truth(std::string(ODDITY_SOURCE) + "/reference");
  return truth;
}

void ok_there(const Entry& entry, const Parameters& there) {
  for (const Quantity& q : entry.exercise.study(there, reference()).quantities)
    for (const Method& m : q.methods) {
      if (m.expected != Outcome::ok) continue;
      const Trial trial = run(q, m, m.resolution.settings.back());
      INFO(q.name << ", " << m.model << ", " << m.algorithm << ": error " << trial.error << ", needed "
                  << q.need.allowed << "; reference: " << q.reference.by);
      CHECK(name_of(trial.outcome) == "ok");
    }
}

/// At a parameter of 1 nobody sees whether a formula contains it, its square or its inverse. Motions are left
/// out: the properties test them at random parameters.
const bool registered = [] {
  for (const Entry& entry : registry())
    if (!entry.exercise.scene)
      register_test([&entry] { ok_there(entry, off_defaults(entry)); },
                    to_string(entry.number) + " off its defaults",
                    "[off_defaults][" + to_string(entry.number) + "]");
  return true;
}();

}  // namespace

TEST_CASE("2.17: the maximum after five turns is found like the first, and the printed one is 2 % too large",
          "[off_defaults][2.17]") {
  const Entry& entry = entry_of(2, 17);
  Parameters off = off_defaults(entry), p(entry.exercise.parameters);
  off.set("turn", 5);
  ok_there(entry, off);
  p.set("turn", 5);
  const Findings found = entry.exercise.study(p, reference());
  const Quantity& q = *std::ranges::find(found.quantities, "maximum", &Quantity::name);
  const Value printed = method_of(q, "closed form", "as printed, W = r omega x sqrt 2")->run(0).value;
  CHECK(near(printed[2] / q.reference.value[2], 1.02, 5e-3));
}

TEST_CASE("2.7: steps of a rotation end when the granted evaluations are spent", "[off_defaults][2.7]") {
  const Entry& entry = entry_of(2, 7);
  const Findings found = entry.exercise.study(Parameters(entry.exercise.parameters), reference());
  const Quantity& q = *std::ranges::find(found.quantities, "orientation", &Quantity::name);
  const Method& magnus = *method_of(q, "rotation vector", "Magnus 4");
  const ode::EvaluationLimit limit(10);
  const Answer answer = magnus.run(magnus.resolution.settings.back());
  CHECK(answer.ending == Ending::stalled);
  CHECK(answer.message == "the budget of evaluations is spent");
}

TEST_CASE("2.7: the departure of a matrix of NaN from a rotation is NaN", "[off_defaults][2.7]") {
  space::Matrix3 turned = space::identity<double>();
  CHECK(curve_on_sphere::departure(turned) == 0);
  turned.e[4] = 2;
  CHECK(curve_on_sphere::departure(turned) == 3);
  turned.e[1] = std::nan("");
  CHECK(std::isnan(curve_on_sphere::departure(turned)));
}

TEST_CASE("3.33: the axis is between its bounds, whether it starts upward or downward",
          "[off_defaults][3.33]") {
  const Entry& entry = entry_of(3, 33);
  for (const double dphi : {-0.4, 0.4}) {
    Parameters p(entry.exercise.parameters);
    p.set("dphi", dphi);
    const Findings found = entry.exercise.study(p, reference());
    const Quantity& q = *std::ranges::find(found.quantities, "nutation_bounds", &Quantity::name);
    INFO("dphi = " << dphi);
    for (const Method& m : q.methods) CHECK(name_of(run(q, m, m.resolution.settings.back()).outcome) == "ok");
  }
}

TEST_CASE("3.35: a top too slow for a steady precession is shaken at the frequency of its nutation",
          "[off_defaults][3.35]") {
  const heavy_top::Top<double> slow{{1, 0.25, 0.125, 0.0625, 9.81, 0.25, 0.5, 0.75, 0.5, 0.25, 1}, 0.0625, 3};
  const heavy_top::HeightAlone<double> height{slow};
  const double period = 2 * std::numbers::pi / ex03_35::nutation_frequency(slow);
  const auto after = [&](double time) {
    return ode::integrate<ode::Fehlberg78>(height, height.start(), 0, time, 1e-12).value;
  };
  for (std::size_t i : {0u, 1u}) CHECK(near(after(period)[i], height.start()[i], 1e-9));
  CHECK_FALSE(near(after(period / 2)[1], height.start()[1], 0.1));
}

TEST_CASE("3.9: let go on the second axis, the ball's arrival is found, and the text's formula has no number",
          "[off_defaults][3.9]") {
  const Entry& entry = entry_of(3, 9);
  Parameters p(entry.exercise.parameters);
  p.set("p1", 0);
  const Findings found = entry.exercise.study(p, reference());
  const Quantity& q = *std::ranges::find(found.quantities, "first_arrival", &Quantity::name);
  for (const Method& m : q.methods)
    CHECK(name_of(run(q, m, m.resolution.settings.back()).outcome) == name_of(m.expected));
  CHECK(name_of(q.breakdowns.at(0).outcome) == name_of(Outcome::non_finite));
}

TEST_CASE("7.11: every method finds the logarithm of a determinant in range", "[off_defaults][7.11]") {
  const Entry& entry = entry_of(7, 11);
  Parameters p(entry.exercise.parameters);
  p.set("e", 1);
  const Findings found = entry.exercise.study(p, Reference::nothing());
  const Quantity& q = *std::ranges::find(found.quantities, "log_determinant", &Quantity::name);
  const double first = q.methods.front().run(0).value[0];
  CHECK(first > 1);
  for (const Method& m : q.methods) {
    INFO(m.model << ", " << m.algorithm);
    CHECK(near(m.run(0).value[0], first, 1e-12 * first));
  }
}

TEST_CASE("7.1: every elimination solves a user's system, and one without a solution is refused",
          "[off_defaults][7.1]") {
  const Entry& entry = entry_of(7, 1);
  const auto found = [&](const std::array<double, 12>& a) {
    Parameters p(entry.exercise.parameters);
    for (std::size_t i = 0; i < a.size(); ++i)
      p.set("a" + std::to_string(i / 4 + 1) + std::to_string(i % 4 + 1), a[i]);
    return entry.exercise.study(p, reference());
  };
  const Findings findings = found({2, 1, -1, 8, -3, -1, 2, -11, -2, 1, 2, -3});
  const Quantity& q = *std::ranges::find(findings.quantities, "own_system", &Quantity::name);
  for (const Method& m : q.methods) {
    INFO(m.algorithm);
    const Value x = m.run(53).value;
    REQUIRE(x.size() == 3);
    const bool is_right = near(x[0], 2, 1e-12) && near(x[1], 3, 1e-12) && near(x[2], -1, 1e-12);
    CHECK(is_right == (m.algorithm != "full, operations as counted in print"));
  }
  CHECK_THROWS_AS(found({1, 2, 3, 1, 2, 4, 6, 1, 0, 1, 1, 1}), BadInput);
}

TEST_CASE("7.11: the determinant of a user's triangular matrix is the product of its diagonal",
          "[off_defaults][7.11]") {
  const Entry& entry = entry_of(7, 11);
  Parameters p(entry.exercise.parameters);
  for (const auto& [name, value] : std::vector<std::pair<const char*, double>>{
           {"u11", 1e60}, {"u22", 1e-60}, {"u33", 3.0}, {"u44", -0.5}})
    p.set(name, value);
  const Findings findings = entry.exercise.study(p, reference());
  const Quantity& q = *std::ranges::find(findings.quantities, "own_determinant", &Quantity::name);
  CHECK(near(q.reference.value[0], -1.5, 1e-15));
  for (const Method& m : q.methods) {
    INFO(m.model << ", " << m.algorithm);
    CHECK(name_of(run(q, m, 0).outcome) == "ok");
  }
}
